// SPDX-License-Identifier: MIT
// The menu View > Evaluation.
#include "ui/actions/actions.h"
#include "ui/main_window/main_window.h"

#include <QActionGroup>

#include <utility>

namespace soffit::ui {

void MainWindow::addEvaluations(QMenu& menu) {
  auto* group = new QActionGroup(this);
  EvaluationChoice* evaluation = workspace_.evaluation;
  const QString hint = tr("Which processor evaluates light in the views; pictures are the same");
  const std::pair<ActionText, Evaluation> all[] = {
      {{tr("&Automatic"), {}, tr("By shaders where there is a graphics processor"), "Automatic"},
       Evaluation::automatic},
      {{tr("&Processor"), {}, hint, "Processor"}, Evaluation::cpu},
      {{tr("&Graphics processor"), {}, hint, "Graphics processor"}, Evaluation::gpu}};
  for (const auto& [text, choice] : all) {
    QAction* action = addEntry(menu, text, this,
                               [evaluation, choice = choice] { evaluation->setWanted(choice); });
    action->setCheckable(true);
    action->setChecked(choice == evaluation->wanted());
    group->addAction(action);
  }
}

}  // namespace soffit::ui
