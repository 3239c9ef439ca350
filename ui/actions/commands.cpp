// SPDX-License-Identifier: MIT
#include "ui/actions/commands.h"

#include <QMenu>
#include <QStringList>

#include <algorithm>

namespace soffit::ui {
namespace {

QString plain(QString text) {
  text.remove(QLatin1Char('&'));
  while (text.endsWith(QLatin1Char('.')) || text.endsWith(QChar(0x2026))) text.chop(1);
  return text;
}

QString nameOf(const QObject& object, const QString& text) {
  return object.objectName().isEmpty() ? text : object.objectName();
}

/// `before`: the menu's id with a slash.
void collect(const QList<QAction*>& actions, const QString& before, const QStringList& place,
             std::vector<Command>& out) {
  for (QAction* action : actions) {
    if (action->isSeparator() || action->text().isEmpty()) continue;
    const QString text = plain(action->text());
    if (const QMenu* menu = action->menu()) {
      collect(menu->actions(), before + nameOf(*menu, text) + QLatin1Char('/'),
              place + QStringList(text), out);
    } else {
      out.push_back(
          {before + nameOf(*action, text), place.join(QStringLiteral(" › ")), text, action});
    }
  }
}

}  // namespace

std::vector<Command> commandsOf(const QMenuBar& menus) {
  std::vector<Command> out;
  collect(menus.actions(), {}, {}, out);
  return out;
}

std::vector<Command> commandsMatching(const std::vector<Command>& commands, const QString& text) {
  const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  std::vector<Command> out;
  for (const Command& c : commands) {
    const QString all = c.place + QLatin1Char(' ') + c.name;
    if (c.action == nullptr) continue;
    const bool holds = std::all_of(words.begin(), words.end(), [&](const QString& word) {
      return all.contains(word, Qt::CaseInsensitive);
    });
    if (holds && c.action->isEnabled() && c.action->isVisible()) out.push_back(c);
  }
  if (words.isEmpty()) return out;
  std::stable_partition(out.begin(), out.end(), [&](const Command& c) {
    return c.name.startsWith(words.front(), Qt::CaseInsensitive);
  });
  return out;
}

}  // namespace soffit::ui
