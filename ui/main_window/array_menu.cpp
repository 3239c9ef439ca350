// SPDX-License-Identifier: MIT
// Luminaire, Array: a live array of the luminaire that is selected, with its numbers over the view.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"
#include "ui/panels/array_bar.h"
#include "ui/viewport/arraying.h"

#include <QMenu>

namespace soffit::ui {

void MainWindow::startArray(ArrayKind kind) {
  if (session_->document().selection().isEmpty()) {
    workspace_.status->showHint(tr("Select the luminaire that is to be repeated first."));
    return;
  }
  ViewArea& area = *workspace_.area;
  area.grid().endTools();  // the old one first: it takes its preview back
  ViewPane& pane = area.grid().working();
  auto tool = std::make_unique<Arraying>(session_->document(), pane.view(), kind);
  Arraying* now = tool.get();
  auto* bar = new ArrayBar(&area);
  connect(now, &Arraying::planChanged, bar, &ArrayBar::showPlan);
  connect(now, &QObject::destroyed, bar, &QObject::deleteLater);
  connect(bar, &ArrayBar::changed, now, &Arraying::setSettings);
  connect(bar, &ArrayBar::applied, now, &Arraying::apply);
  connect(bar, &ArrayBar::cancelled, this, [this] { workspace_.area->grid().endTools(); });
  bar->showPlan(now->plan(), now->wanted());
  // Under the view's own bar.
  bar->move(pane.bar().geometry().bottomLeft() + QPoint(0, 8));
  bar->setVisible(true);
  pane.input().setTool(std::move(tool));
  now->setSettings(now->wanted());  // setTool() has cleared what the view showed
}

void MainWindow::addArrayEntries(QMenu& menu) {
  const std::tuple<QString, const char*, ArrayKind> kinds[] = {
      {tr("&Line"), "Line", ArrayKind::line_x},
      {tr("&Rectangle"), "Rectangle", ArrayKind::rectangle},
      {tr("&Circle"), "Circle", ArrayKind::circle}};
  for (const auto& [text, name, kind] : kinds) {
    forProject(
        addEntry(menu, {text, {}, {}, name}, this, [this, kind = kind] { startArray(kind); }));
  }
}

}  // namespace soffit::ui
