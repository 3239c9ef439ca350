// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QMenuBar>
#include <QPointer>
#include <QString>

#include <vector>

namespace soffit::ui {

/// An entry of the menus.
struct Command {
  QString id;                ///< its place and name in every language: "Edit/Snap to/Grid of 0.1 m"
  QString place;             ///< for people, in theirs: "Edit › Snap to"
  QString name;              ///< without the mark of its mnemonic and without "..."
  QPointer<QAction> action;  ///< null when the entry is gone: recent files come and go
};

/// All entries of a menu bar in the order in which they stand there; separators and menus
/// themselves left out. Ids are the object names of menus and entries; of what has none, its text.
std::vector<Command> commandsOf(const QMenuBar& menus);

/// Those that may be run now and hold all words of `text` (in any order and case), the ones whose
/// name begins with it first.
std::vector<Command> commandsMatching(const std::vector<Command>& commands, const QString& text);

}  // namespace soffit::ui
