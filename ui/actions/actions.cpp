// SPDX-License-Identifier: MIT
#include "ui/actions/actions.h"

namespace soffit::ui {
namespace {

QAction* add(QMenu& menu, const ActionText& text) {
  QAction* action = menu.addAction(text.text);
  action->setShortcut(text.keys);
  action->setObjectName(QString::fromLatin1(text.name));
  if (!text.hint.isEmpty()) {
    action->setToolTip(text.hint);
    action->setStatusTip(text.hint);
  }
  return action;
}

}  // namespace

QMenu& named(QMenu* menu, const char* name) {
  menu->setObjectName(QString::fromLatin1(name));
  return *menu;
}

QAction* addEntry(QMenu& menu, const ActionText& text, QObject* context,
                  const std::function<void()>& run) {
  QAction* action = add(menu, text);
  QObject::connect(action, &QAction::triggered, context, run);
  return action;
}

QAction* addToggle(QMenu& menu, const ActionText& text, QObject* context,
                   const std::function<void(bool)>& run) {
  QAction* action = add(menu, text);
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, context, run);
  return action;
}

}  // namespace soffit::ui
