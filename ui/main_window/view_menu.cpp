// SPDX-License-Identifier: MIT
// The part of the View menu that is about where one looks from.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"

#include <utility>

namespace soffit::ui {

void MainWindow::addCameraEntries(QMenu& menu) {
  const auto view = [this]() -> SceneView& { return workspace_.area->view(); };
  const auto camera = [this]() -> CameraControl& { return workspace_.area->input().camera(); };
  forProject(addEntry(menu, {tr("Frame &all"), QKeySequence(Qt::Key_Home), {}}, this,
                      [view] { view().frameAll(); }));
  forProject(addEntry(menu, {tr("Frame &selection"), QKeySequence(Qt::Key_Period), {}}, this,
                      [view] { view().frameSelection(); }));
  addStandardViews(*menu.addMenu(tr("&Look from")));
  forProject(addEntry(menu,
                      {tr("Pre&vious place"), QKeySequence(tr("Alt+Left")),
                       tr("Back to where this view was looked from before")},
                      this, [camera] { camera().back(); }));
  forProject(addEntry(
      menu,
      {tr("&Next place"), QKeySequence(tr("Alt+Right")), tr("Forward again after going back")},
      this, [camera] { camera().forward(); }));
}

void MainWindow::addStandardViews(QMenu& menu) {
  const std::pair<StandardView, ActionText> entries[] = {
      {StandardView::perspective,
       {tr("&Perspective"), QKeySequence(tr("Alt+1")), tr("As the eye sees; as it was left")}},
      {StandardView::plan,
       {tr("P&lan"), QKeySequence(tr("Shift+Home")), tr("From above, cut above the tables")}},
      {StandardView::front, {tr("&Front"), QKeySequence(tr("Alt+2")), {}}},
      {StandardView::back, {tr("&Back"), QKeySequence(tr("Alt+3")), {}}},
      {StandardView::left, {tr("L&eft side"), QKeySequence(tr("Alt+4")), {}}},
      {StandardView::right, {tr("&Right side"), QKeySequence(tr("Alt+5")), {}}},
      {StandardView::section_front, {tr("&Section from the front"), QKeySequence(tr("Alt+6")), {}}},
      {StandardView::section_back, {tr("Section from the b&ack"), QKeySequence(tr("Alt+7")), {}}},
      {StandardView::section_left, {tr("Section from the lef&t"), QKeySequence(tr("Alt+8")), {}}},
      {StandardView::section_right,
       {tr("Section from the ri&ght"), QKeySequence(tr("Alt+9")), {}}}};
  for (const auto& [view, text] : entries) {
    forProject(
        addEntry(menu, text, this, [this, view = view] { workspace_.area->pane().show(view); }));
  }
}

}  // namespace soffit::ui
