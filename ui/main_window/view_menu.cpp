// SPDX-License-Identifier: MIT
// The part of the View menu that is about where one looks from.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"

#include <QActionGroup>

#include <utility>

namespace soffit::ui {

void MainWindow::addCameraEntries(QMenu& menu) {
  const auto view = [this]() -> SceneView& { return workspace_.area->active().view(); };
  const auto camera = [this]() -> CameraControl& {
    return workspace_.area->active().input().camera();
  };
  forProject(addEntry(menu, {tr("Frame &all"), QKeySequence(Qt::Key_Home), {}, "Frame all"}, this,
                      [view] { view().frameAll(); }));
  forProject(addEntry(menu,
                      {tr("Frame &selection"), QKeySequence(Qt::Key_Period), {}, "Frame selection"},
                      this, [view] { view().frameSelection(); }));
  addStandardViews(named(menu.addMenu(tr("&Look from")), "Look from"));
  forProject(addEntry(menu,
                      {tr("Pre&vious place"), QKeySequence(tr("Alt+Left")),
                       tr("Back to where this view was looked from before"), "Previous place"},
                      this, [camera] { camera().back(); }));
  forProject(addEntry(menu,
                      {tr("&Next place"), QKeySequence(tr("Alt+Right")),
                       tr("Forward again after going back"), "Next place"},
                      this, [camera] { camera().forward(); }));
  menu.addSeparator();
  addArrangements(named(menu.addMenu(tr("Vie&ws")), "Views"));
  QMenu& cameras = named(menu.addMenu(tr("&Cameras")), "Cameras");
  forProject(addEntry(cameras, {tr("&Save view as camera"), {}, {}, "Save view as camera"}, this,
                      [this] { Q_EMIT workspace_.cameras->saveRequested(); }));
  forProject(addEntry(cameras,
                      {tr("&Next camera"), QKeySequence(Qt::Key_PageDown), {}, "Next camera"}, this,
                      [this] { workspace_.cameras->chooseNext(1); }));
  forProject(addEntry(cameras,
                      {tr("&Previous camera"), QKeySequence(Qt::Key_PageUp), {}, "Previous camera"},
                      this, [this] { workspace_.cameras->chooseNext(-1); }));
}

void MainWindow::addArrangements(QMenu& menu) {
  using Arrangement = ViewGrid::Arrangement;
  const std::pair<Arrangement, ActionText> entries[] = {
      {Arrangement::one, {tr("&One"), QKeySequence(tr("Ctrl+Alt+1")), {}, "One"}},
      {Arrangement::beside,
       {tr("Two &beside each other"), QKeySequence(tr("Ctrl+Alt+2")), {}, "Two beside each other"}},
      {Arrangement::over,
       {tr("Two, one o&ver the other"),
        QKeySequence(tr("Ctrl+Alt+3")),
        {},
        "Two, one over the other"}},
      {Arrangement::four, {tr("&Four"), QKeySequence(tr("Ctrl+Alt+4")), {}, "Four"}}};
  ViewGrid& grid = workspace_.area->grid();
  auto* group = new QActionGroup(this);
  for (const auto& [arrangement, text] : entries) {
    QAction* action = addEntry(
        menu, text, this, [&grid, arrangement = arrangement] { grid.setArrangement(arrangement); });
    action->setCheckable(true);
    action->setChecked(arrangement == grid.arrangement());
    group->addAction(action);
    forProject(action);
    connect(&grid, &ViewGrid::arrangementChanged, action,
            [action, &grid, arrangement = arrangement] {
              action->setChecked(grid.arrangement() == arrangement);
            });
  }
}

void MainWindow::addStandardViews(QMenu& menu) {
  const std::pair<StandardView, ActionText> entries[] = {
      {StandardView::perspective,
       {tr("&Perspective"), QKeySequence(tr("Alt+1")), tr("As the eye sees; as it was left"),
        "Perspective"}},
      {StandardView::plan,
       {tr("P&lan"), QKeySequence(tr("Shift+Home")), tr("From above, cut above the tables"),
        "Plan"}},
      {StandardView::front, {tr("&Front"), QKeySequence(tr("Alt+2")), {}, "Front"}},
      {StandardView::back, {tr("&Back"), QKeySequence(tr("Alt+3")), {}, "Back"}},
      {StandardView::left, {tr("L&eft side"), QKeySequence(tr("Alt+4")), {}, "Left side"}},
      {StandardView::right, {tr("&Right side"), QKeySequence(tr("Alt+5")), {}, "Right side"}},
      {StandardView::section_front,
       {tr("&Section from the front"), QKeySequence(tr("Alt+6")), {}, "Section from the front"}},
      {StandardView::section_back,
       {tr("Section from the b&ack"), QKeySequence(tr("Alt+7")), {}, "Section from the back"}},
      {StandardView::section_left,
       {tr("Section from the lef&t"), QKeySequence(tr("Alt+8")), {}, "Section from the left"}},
      {StandardView::section_right,
       {tr("Section from the ri&ght"), QKeySequence(tr("Alt+9")), {}, "Section from the right"}}};
  for (const auto& [view, text] : entries) {
    forProject(
        addEntry(menu, text, this, [this, view = view] { workspace_.area->active().show(view); }));
  }
}

}  // namespace soffit::ui
