// SPDX-License-Identifier: MIT
// The menu Calculate.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"

#include <QDockWidget>
#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeCalculateMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&Calculate")), "Calculate");
  const auto raise = [this](const QString& name) {
    auto* dock = findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
  };
  forProject(addEntry(menu,
                      {tr("&Verify with the path tracer"), QKeySequence(tr("Ctrl+Shift+V")),
                       tr("Computes the light independently in the background and compares"),
                       "Verify with the path tracer"},
                      this, [this, raise] {
                        raise(QStringLiteral("verify"));
                        workspace_.verify->start();
                      }));
  QAction* map = addToggle(menu,
                           {tr("Show the &errors in the view"),
                            {},
                            tr("Of the points that were verified"),
                            "Show the errors in the view"},
                           this, [this](bool on) { workspace_.verify->setMapWanted(on); });
  forProject(map);
  connect(workspace_.verify, &VerifyPanel::mapWantedChanged, map, &QAction::setChecked);
  menu.addSeparator();
  forProject(addEntry(menu, {tr("&Quality and times"), {}, {}, "Quality and times"}, this,
                      [raise] { raise(QStringLiteral("quality")); }));
  forProject(addEntry(menu,
                      {tr("&Stop computing"),
                       {},
                       tr("Gives up the precomputation or the verification under way"),
                       "Stop computing"},
                      this, [this] {
                        session_->verification().cancel();
                        session_->relighting().worker().cancelBake();
                      }));
}

}  // namespace soffit::ui
