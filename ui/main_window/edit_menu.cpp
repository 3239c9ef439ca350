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
  QMenu& menu = named(menuBar()->addMenu(tr("&Edit")), "Edit");
  // Without a prefix the words are Qt's own, which put the step where the language wants it.
  QAction* undo = undo_->createUndoAction(this);
  undo->setObjectName(QStringLiteral("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = undo_->createRedoAction(this);
  redo->setObjectName(QStringLiteral("Redo"));
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  menu.addActions({undo, redo});
  menu.addSeparator();
  const auto add = [&](const QString& text, const QKeySequence& keys, const char* name,
                       void (*run)(Document&)) {
    forProject(
        addEntry(menu, {text, keys, {}, name}, this, [this, run] { run(session_->document()); }));
  };
  add(tr("Cu&t"), QKeySequence::Cut, "Cut", &cutSelection);
  forProject(addEntry(menu, {tr("&Copy"), QKeySequence::Copy, {}, "Copy"}, this,
                      [this] { copySelection(session_->document()); }));
  forProject(addEntry(menu, {tr("&Paste"), QKeySequence::Paste, {}, "Paste"}, this, [this] {
    if (const auto pasted = paste(session_->document()); !pasted) {
      showError(this, tr("Not pasted"), messageOf(pasted.error()));
    }
  }));
  add(tr("&Duplicate"), QKeySequence(tr("Ctrl+D")), "Duplicate", &duplicateSelection);
  add(tr("De&lete"), QKeySequence::Delete, "Delete", &deleteSelection);
  add(tr("Select &all"), QKeySequence::SelectAll, "Select all", &selectAll);
  menu.addSeparator();
  addGizmoTools(menu);
  addSnapping(named(menu.addMenu(tr("&Snap to")), "Snap to"));
}

void MainWindow::addGizmoTools(QMenu& menu) {
  ViewInput& input = workspace_.area->input();
  auto* group = new QActionGroup(this);
  const std::tuple<ActionText, GizmoTool> tools[] = {
      {{tr("&Move"), QKeySequence(Qt::Key_W), {}, "Move"}, GizmoTool::move},
      {{tr("&Rotate"), QKeySequence(Qt::Key_E), {}, "Rotate"}, GizmoTool::rotate},
      {{tr("Resi&ze"), QKeySequence(Qt::Key_R), {}, "Resize"}, GizmoTool::scale}};
  for (const auto& [text, tool] : tools) {
    QAction* action =
        addEntry(menu, text, this, [&input, tool = tool] { input.setGizmoTool(tool); });
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
  const auto add = [&](const ActionText& text, const QString& key, bool& rule) {
    rule = QSettings().value(key, rule).toBool();
    QAction* action = addToggle(menu, text, this, [&rule, key](bool on) {
      rule = on;
      QSettings().setValue(key, on);
    });
    action->setChecked(rule);
    forProject(action);
  };
  add({tr("&Ceiling and walls"), {}, tr("Also the middle between two walls"), "Ceiling and walls"},
      QStringLiteral("snap/surfaces"), rules.surfaces);
  add({tr("Other &luminaires"),
       {},
       tr("Their axes, and their spacing carried on"),
       "Other luminaires"},
      QStringLiteral("snap/luminaires"), rules.luminaires);
  add({tr("&Grid of 0.1 m"),
       {},
       tr("Where nothing else attracts; Ctrl while dragging does the same"),
       "Grid of 0.1 m"},
      QStringLiteral("snap/grid"), rules.grid);
}

}  // namespace soffit::ui
