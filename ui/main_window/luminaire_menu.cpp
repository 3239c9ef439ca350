// SPDX-License-Identifier: MIT
// The Luminaire menu: what is done to the luminaires that are selected.
#include "ui/actions/actions.h"
#include "ui/actions/luminaire_actions.h"
#include "ui/main_window/main_window.h"
#include "ui/viewport/aiming.h"

#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeLuminaireMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Luminaire"));
  const auto add = [&](const QString& text, const QKeySequence& keys, void (*run)(Document&)) {
    forProject(addEntry(menu, {text, keys, {}}, this, [this, run] { run(session_->document()); }));
  };
  add(tr("Switch &on or off"), QKeySequence(Qt::Key_O), &toggleSelection);
  QMenu& dim = *menu.addMenu(tr("&Dim to"));
  for (const int percent : {100, 75, 50, 25, 10}) {
    forProject(addEntry(dim, {tr("%1 %").arg(percent), {}, {}}, this,
                        [this, percent] { dimSelection(session_->document(), percent / 100.0); }));
  }
  menu.addSeparator();
  forProject(addEntry(menu,
                      {tr("&Aim at\u2026"), QKeySequence(Qt::Key_A),
                       tr("Click the point of a surface that the selection is to light")},
                      this, [this] {
                        if (session_->document().selection().isEmpty()) return;
                        workspace_.area->grid().endTools();
                        workspace_.area->active().input().setTool(
                            std::make_unique<Aiming>(session_->document()));
                      }));
  addArrayEntries(*menu.addMenu(tr("A&rray")));
  menu.addSeparator();
  add(tr("&Hide"), QKeySequence(Qt::Key_H), &hideSelection);
  add(tr("Hide o&thers"), QKeySequence(tr("Shift+H")), &hideOthers);
  add(tr("&Show all"), QKeySequence(tr("Ctrl+H")), &showHidden);
  menu.addSeparator();
  QMenu& scenes = *menu.addMenu(tr("&Light scenes"));
  for (std::size_t i = 0; i < kMostScenes; ++i) {
    const int digit = Qt::Key_1 + static_cast<int>(i);
    forProject(addEntry(scenes, {tr("Recall scene %1").arg(i + 1), QKeySequence(digit), {}}, this,
                        [this, i] { workspace_.mixer->recall(i); }));
  }
  scenes.addSeparator();
  for (std::size_t i = 0; i < kMostScenes; ++i) {
    const int digit = Qt::Key_1 + static_cast<int>(i);
    forProject(addEntry(
        scenes, {tr("Store scene %1").arg(i + 1), QKeySequence(Qt::CTRL | Qt::Key(digit)), {}},
        this, [this, i] { workspace_.mixer->store(i); }));
  }
}

}  // namespace soffit::ui
