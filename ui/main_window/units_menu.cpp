// SPDX-License-Identifier: MIT
// The menu View > Units.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"
#include "ui/widgets/units.h"

#include <QActionGroup>

#include <utility>

namespace soffit::ui {

void MainWindow::addUnits(QMenu& menu) {
  auto* group = new QActionGroup(this);
  const QString hint = tr("How values are shown; files stay metric");
  const std::pair<ActionText, Units> all[] = {
      {{tr("Metric: m, lx"), {}, hint, "Metric: m, lx"}, Units::metric},
      {{tr("Imperial: ft, fc"), {}, hint, "Imperial: ft, fc"}, Units::imperial}};
  for (const auto& [text, choice] : all) {
    QAction* action = addEntry(menu, text, this, [choice = choice] {
      saveUnits(choice);
      applyUnits(choice);
    });
    action->setCheckable(true);
    action->setChecked(choice == savedUnits());
    group->addAction(action);
  }
}

}  // namespace soffit::ui
