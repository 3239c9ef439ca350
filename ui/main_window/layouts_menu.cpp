// SPDX-License-Identifier: MIT
// The menu Layouts.
#include "ui/actions/actions.h"
#include "ui/document/text.h"
#include "ui/main_window/main_window.h"

#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeLayoutsMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("L&ayouts")), "Layouts");
  LayoutsPanel* panel = workspace_.layouts;
  forProject(addEntry(menu,
                      {tr("&Duplicate the layout shown"),
                       QKeySequence(tr("Ctrl+L")),
                       {},
                       "Duplicate the layout shown"},
                      this, [panel] { panel->duplicateShown(); }));
  forProject(addEntry(menu, {tr("&Rename\u2026"), {}, {}, "Rename"}, this, [panel] {
    panel->window()->activateWindow();
    panel->parentWidget()->show();
    panel->parentWidget()->raise();
    panel->renameShown();
  }));
  forProject(addEntry(menu, {tr("De&lete the layout shown"), {}, {}, "Delete the layout shown"},
                      this, [panel] { panel->deleteShown(); }));
  forProject(
      addEntry(menu, {tr("Move &up"), {}, {}, "Move up"}, this, [panel] { panel->moveShown(-1); }));
  forProject(addEntry(menu, {tr("Move do&wn"), {}, {}, "Move down"}, this,
                      [panel] { panel->moveShown(1); }));
  menu.addSeparator();
  forProject(addEntry(menu, {tr("&Next layout"), QKeySequence(Qt::Key_V), {}, "Next layout"}, this,
                      [this] {
                        Document& document = session_->document();
                        QStringList names{QString()};
                        for (const auto& layout : document.scene()->layouts)
                          names.append(toQt(layout.name));
                        const auto at = names.indexOf(document.layout());
                        document.setLayout(names[(at + 1) % names.size()]);
                      }));
  menu.addSeparator();
  const auto compare = [this](ComparisonMode mode) { session_->comparison().setMode(mode); };
  forProject(addEntry(menu, {tr("Compare with a &slider"), {}, {}, "Compare with a slider"}, this,
                      [compare] { compare(ComparisonMode::split); }));
  forProject(addEntry(menu, {tr("Compare side &by side"), {}, {}, "Compare side by side"}, this,
                      [compare] { compare(ComparisonMode::side_by_side); }));
  forProject(addEntry(menu,
                      {tr("Bl&ink"), QKeySequence(Qt::Key_B),
                       tr("This layout and another in turn; again: stop"), "Blink"},
                      this, [this, compare] {
                        const bool blinks = session_->comparison().mode() == ComparisonMode::blink;
                        compare(blinks ? ComparisonMode::off : ComparisonMode::blink);
                      }));
  forProject(addEntry(menu, {tr("Difference in lu&x"), {}, {}, "Difference in lux"}, this,
                      [compare] { compare(ComparisonMode::difference); }));
  forProject(addEntry(
      menu, {tr("&End the comparison"), QKeySequence(tr("Shift+B")), {}, "End the comparison"},
      this, [compare] { compare(ComparisonMode::off); }));
}

}  // namespace soffit::ui
