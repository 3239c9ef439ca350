// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/commands.h"

#include <QKeySequence>
#include <QMap>
#include <QObject>

namespace soffit::ui {

/// The keys of all menu entries: as built in, as in a preset, and as the user changed them. What
/// the user changed wins, then the preset. Kept in the settings.
class KeyBindings : public QObject {
  Q_OBJECT

 public:
  /// Takes the entries' present keys as the built-in ones and applies what is kept.
  KeyBindings(const QMenuBar& menus, QObject* parent);

  [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }
  [[nodiscard]] QKeySequence keys(const QString& id) const;
  [[nodiscard]] bool isChanged(const QString& id) const { return changed_.contains(id); }
  /// The entry that has these keys now, other than `id`; null for none or empty keys.
  [[nodiscard]] const Command* takenBy(const QKeySequence& keys, const QString& id) const;

  /// Gives an entry these keys; one that had them loses them. Empty: no keys.
  void assign(const QString& id, const QKeySequence& keys);
  /// Back to the preset's keys.
  void reset(const QString& id);
  void resetAll();

  static QStringList presets();
  /// Ids of the entries that a preset gives keys to.
  static QStringList commandsOfPreset(const QString& preset);
  [[nodiscard]] QString preset() const { return preset_; }
  /// Errors: none; an unknown name is the first preset.
  void setPreset(const QString& name);

 Q_SIGNALS:
  void changed();

 private:
  [[nodiscard]] QList<QKeySequence> unchanged(const Command& command) const;
  void apply();
  void save() const;

  std::vector<Command> commands_;
  std::vector<QList<QKeySequence>> built_in_;
  QString preset_;
  QMap<QString, QKeySequence> changed_;
};

}  // namespace soffit::ui
