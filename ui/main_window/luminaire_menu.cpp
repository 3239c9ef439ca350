// SPDX-License-Identifier: MIT
// The Luminaire menu: what is done to the luminaires that are selected.
#include "ui/actions/actions.h"
#include "ui/actions/luminaire_actions.h"
#include "ui/main_window/main_window.h"
#include "ui/viewport/aiming.h"

#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeLuminaireMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&Luminaire")), "Luminaire");
  const auto add = [&](const QString& text, const QKeySequence& keys, const char* name,
                       void (*run)(Document&)) {
    forProject(
        addEntry(menu, {text, keys, {}, name}, this, [this, run] { run(session_->document()); }));
  };
  const auto numbered = [](const char* name, int number) {
    return QString::fromLatin1(name).arg(number).toLatin1();
  };
  add(tr("Switch &on or off"), QKeySequence(Qt::Key_O), "Switch on or off", &toggleSelection);
  QMenu& dim = named(menu.addMenu(tr("&Dim to")), "Dim to");
  for (const int percent : {100, 75, 50, 25, 10}) {
    forProject(addEntry(dim, {tr("%1 %").arg(percent), {}, {}, numbered("%1 %", percent)}, this,
                        [this, percent] { dimSelection(session_->document(), percent / 100.0); }));
  }
  menu.addSeparator();
  forProject(addEntry(menu,
                      {tr("&Aim at\u2026"), QKeySequence(Qt::Key_A),
                       tr("Click the point of a surface that the selection is to light"), "Aim at"},
                      this, [this] {
                        if (session_->document().selection().isEmpty()) return;
                        workspace_.area->grid().endTools();
                        workspace_.area->grid().working().input().setTool(
                            std::make_unique<Aiming>(session_->document()));
                      }));
  addArrayEntries(named(menu.addMenu(tr("A&rray")), "Array"));
  menu.addSeparator();
  add(tr("&Hide"), QKeySequence(Qt::Key_H), "Hide", &hideSelection);
  add(tr("Hide o&thers"), QKeySequence(tr("Shift+H")), "Hide others", &hideOthers);
  add(tr("&Show all"), QKeySequence(tr("Ctrl+H")), "Show all", &showHidden);
  menu.addSeparator();
  QMenu& scenes = named(menu.addMenu(tr("&Light scenes")), "Light scenes");
  for (std::size_t i = 0; i < kMostScenes; ++i) {
    const int digit = Qt::Key_1 + static_cast<int>(i);
    forProject(addEntry(scenes,
                        {tr("Recall scene %1").arg(i + 1),
                         QKeySequence(digit),
                         {},
                         numbered("Recall scene %1", digit - Qt::Key_0)},
                        this, [this, i] { workspace_.mixer->recall(i); }));
  }
  scenes.addSeparator();
  for (std::size_t i = 0; i < kMostScenes; ++i) {
    const int digit = Qt::Key_1 + static_cast<int>(i);
    forProject(addEntry(scenes,
                        {tr("Store scene %1").arg(i + 1),
                         QKeySequence(Qt::CTRL | Qt::Key(digit)),
                         {},
                         numbered("Store scene %1", digit - Qt::Key_0)},
                        this, [this, i] { workspace_.mixer->store(i); }));
  }
}

}  // namespace soffit::ui
