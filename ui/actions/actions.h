// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QByteArray>
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
  /// What kept keys know it by, the same in every language: its English text without marks. Empty:
  /// an entry that keeps no keys, such as a recent file.
  QByteArray name = {};
};

/// Gives a menu the name that stands before those of its entries.
QMenu& named(QMenu* menu, const char* name);

/// Adds an entry that calls `run`.
QAction* addEntry(QMenu& menu, const ActionText& text, QObject* context,
                  const std::function<void()>& run);

/// Adds an entry with a tick that calls `run` with its state.
QAction* addToggle(QMenu& menu, const ActionText& text, QObject* context,
                   const std::function<void(bool)>& run);

}  // namespace soffit::ui
