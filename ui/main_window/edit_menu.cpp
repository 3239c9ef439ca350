// SPDX-License-Identifier: MIT
// The Edit menu: undo, clipboard, selection, the gizmo's tools and what drags snap to.
#include "ui/actions/actions.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/luminaire_actions.h"
#include "ui/document/text.h"
#include "ui/main_window/main_window.h"

#include <QActionGroup>
#include <QMenuBar>
#include <QSettings>
#include <QUndoGroup>

namespace soffit::ui {

void MainWindow::makeEditMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  QAction* undo = undo_->createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = undo_->createRedoAction(this, tr("Redo"));
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  menu.addActions({undo, redo});
  menu.addSeparator();
  const auto add = [&](const QString& text, const QKeySequence& keys, void (*run)(Document&)) {
    forProject(addEntry(menu, {text, keys, {}}, this, [this, run] { run(session_->document()); }));
  };
  add(tr("Cu&t"), QKeySequence::Cut, &cutSelection);
  forProject(addEntry(menu, {tr("&Copy"), QKeySequence::Copy, {}}, this,
                      [this] { copySelection(session_->document()); }));
  forProject(addEntry(menu, {tr("&Paste"), QKeySequence::Paste, {}}, this, [this] {
    if (const auto pasted = paste(session_->document()); !pasted) {
      showError(this, tr("Not pasted"), messageOf(pasted.error()));
    }
  }));
  add(tr("&Duplicate"), QKeySequence(tr("Ctrl+D")), &duplicateSelection);
  add(tr("De&lete"), QKeySequence::Delete, &deleteSelection);
  add(tr("Select &all"), QKeySequence::SelectAll, &selectAll);
  menu.addSeparator();
  addGizmoTools(menu);
  addSnapping(*menu.addMenu(tr("&Snap to")));
}

void MainWindow::addGizmoTools(QMenu& menu) {
  ViewInput& input = workspace_.area->input();
  auto* group = new QActionGroup(this);
  const std::tuple<QString, Qt::Key, GizmoTool> tools[] = {
      {tr("&Move"), Qt::Key_W, GizmoTool::move},
      {tr("&Rotate"), Qt::Key_E, GizmoTool::rotate},
      {tr("Resi&ze"), Qt::Key_R, GizmoTool::scale}};
  for (const auto& [text, key, tool] : tools) {
    QAction* action = addEntry(menu, {text, QKeySequence(key), {}}, this,
                               [&input, tool = tool] { input.setGizmoTool(tool); });
    action->setCheckable(true);
    action->setChecked(tool == workspace_.area->view().gizmoTool());
    group->addAction(action);
    forProject(action);
    connect(&input, &ViewInput::gizmoToolChanged, action,
            [action, tool = tool](GizmoTool now) { action->setChecked(now == tool); });
  }
}

void MainWindow::addSnapping(QMenu& menu) {
  SnapRules& rules = workspace_.area->input().snapRules();
  const auto add = [&](const QString& text, const QString& key, bool& rule, const QString& hint) {
    rule = QSettings().value(key, rule).toBool();
    QAction* action = addToggle(menu, {text, {}, hint}, this, [&rule, key](bool on) {
      rule = on;
      QSettings().setValue(key, on);
    });
    action->setChecked(rule);
    forProject(action);
  };
  add(tr("&Ceiling and walls"), QStringLiteral("snap/surfaces"), rules.surfaces,
      tr("Also the middle between two walls"));
  add(tr("Other &luminaires"), QStringLiteral("snap/luminaires"), rules.luminaires,
      tr("Their axes, and their spacing carried on"));
  add(tr("&Grid of 0.1 m"), QStringLiteral("snap/grid"), rules.grid,
      tr("Where nothing else attracts; Ctrl while dragging does the same"));
}

}  // namespace soffit::ui
