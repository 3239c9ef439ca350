// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QString>

#include <functional>

namespace soffit::ui {

/// What a menu entry is made of.
struct ActionText {
  QString text;
  QKeySequence keys;
  QString hint;  ///< tool tip and status tip; may be empty
};

/// Adds an entry that calls `run`.
QAction* addEntry(QMenu& menu, const ActionText& text, QObject* context,
                  const std::function<void()>& run);

/// Adds an entry with a tick that calls `run` with its state.
QAction* addToggle(QMenu& menu, const ActionText& text, QObject* context,
                   const std::function<void(bool)>& run);

}  // namespace soffit::ui
