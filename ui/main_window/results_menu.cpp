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
  forProject(addEntry(menu,
                      {tr("&Pin a probe"), QKeySequence(Qt::Key_P),
                       tr("Watches the light at the surface under the cursor"), "Pin a probe"},
                      this, [this] { session_->marks().pinProbe(); }));
  forProject(addEntry(menu,
                      {tr("Pro&file along a line\u2026"), QKeySequence(tr("Shift+P")),
                       tr("Click two points of a surface: the light between them as a chart"),
                       "Profile along a line"},
                      this, [this] { session_->marks().drawProfile(); }));
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
