// SPDX-License-Identifier: MIT
// The menu Results.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"

#include <QDockWidget>
#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeResultsMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&Results")), "Results");
  forProject(addEntry(menu,
                      {tr("Show the &table"), QKeySequence(tr("Ctrl+R")), {}, "Show the table"},
                      this, [this] {
                        auto* dock = findChild<QDockWidget*>(QStringLiteral("results"));
                        dock->show();
                        dock->raise();
                      }));
  forProject(
      addEntry(menu, {tr("&Copy the table"), {}, tr("As text for a spreadsheet"), "Copy the table"},
               this, [this] { workspace_.results->copy(); }));
  forProject(addEntry(menu,
                      {tr("&Export the table\u2026"),
                       {},
                       tr("The figures of all layouts as comma-separated values"),
                       "Export the table"},
                      this, [this] { session_->exportResults(); }));
}

}  // namespace soffit::ui
