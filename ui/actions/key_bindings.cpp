// SPDX-License-Identifier: MIT
#include "ui/actions/key_bindings.h"

#include <QSettings>

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

const QString kPreset = QStringLiteral("keys/preset");
const QString kChanged = QStringLiteral("keys/changed");

using Pairs = std::vector<std::pair<const char*, const char*>>;

/// Habits of other programs, for the commands that Soffit has, too.
const std::vector<std::pair<QString, Pairs>>& table() {
  static const std::vector<std::pair<QString, Pairs>> presets = {
      {QStringLiteral("Soffit"), {}},
      {QStringLiteral("Blender"),
       {{"Edit/Move", "G"},
        {"Edit/Rotate", "R"},
        {"Edit/Resize", "S"},
        {"Edit/Duplicate", "Shift+D"},
        {"Edit/Select all", "A"},
        {"Luminaire/Aim at", "Shift+T"},
        {"Luminaire/Hide", "H"},
        {"Luminaire/Hide others", "Shift+H"},
        {"Luminaire/Show all", "Alt+H"},
        {"View/Look from/Perspective", "Num+5"},
        {"View/Look from/Plan", "Num+7"},
        {"View/Look from/Front", "Num+1"},
        {"View/Look from/Back", "Ctrl+Num+1"},
        {"View/Cameras/Next camera", "Num+0"},
        {"View/Look from/Right side", "Num+3"},
        {"View/Look from/Left side", "Ctrl+Num+3"}}},
      {QStringLiteral("SketchUp"),
       {{"Edit/Move", "M"},
        {"Edit/Rotate", "Q"},
        {"Edit/Resize", "S"},
        {"View/Frame all", "Shift+Z"}}}};
  return presets;
}

/// Commands that had another name when keys were kept for them.
QString presentName(const QString& kept) {
  if (kept == QLatin1String("View/Plan from above")) return QStringLiteral("View/Look from/Plan");
  return kept;
}

const Pairs& pairsOf(const QString& preset) {
  for (const auto& [name, pairs] : table()) {
    if (name == preset) return pairs;
  }
  return table().front().second;
}

}  // namespace

KeyBindings::KeyBindings(const QMenuBar& menus, QObject* parent)
    : QObject(parent), commands_(commandsOf(menus)) {
  for (const Command& c : commands_) built_in_.push_back(c.action->shortcuts());
  QSettings settings;
  preset_ = settings.value(kPreset, presets().front()).toString();
  if (!presets().contains(preset_)) preset_ = presets().front();
  const QMap<QString, QVariant> kept = settings.value(kChanged).toMap();
  for (auto it = kept.begin(); it != kept.end(); ++it) {
    changed_[presentName(it.key())] =
        QKeySequence(it.value().toString(), QKeySequence::PortableText);
  }
  apply();
}

QStringList KeyBindings::presets() {
  QStringList names;
  for (const auto& [name, pairs] : table()) names.append(name);
  return names;
}

QStringList KeyBindings::commandsOfPreset(const QString& preset) {
  QStringList ids;
  for (const auto& [id, keys] : pairsOf(preset)) ids.append(QLatin1String(id));
  return ids;
}

QKeySequence KeyBindings::keys(const QString& id) const {
  for (const Command& c : commands_) {
    if (c.id == id && c.action != nullptr) return c.action->shortcut();
  }
  return {};
}

const Command* KeyBindings::takenBy(const QKeySequence& keys, const QString& id) const {
  if (keys.isEmpty()) return nullptr;
  for (const Command& c : commands_) {
    if (c.id == id || c.action == nullptr) continue;
    if (c.action->shortcuts().contains(keys)) return &c;
  }
  return nullptr;
}

void KeyBindings::assign(const QString& id, const QKeySequence& keys) {
  if (const Command* other = takenBy(keys, id)) changed_[other->id] = QKeySequence();
  changed_[id] = keys;
  apply();
  save();
}

void KeyBindings::reset(const QString& id) {
  changed_.remove(id);
  apply();
  save();
}

void KeyBindings::resetAll() {
  changed_.clear();
  apply();
  save();
}

void KeyBindings::setPreset(const QString& name) {
  preset_ = presets().contains(name) ? name : presets().front();
  apply();
  save();
}

QList<QKeySequence> KeyBindings::unchanged(const Command& command) const {
  const Pairs& pairs = pairsOf(preset_);
  for (const auto& [id, keys] : pairs) {
    if (command.id == QLatin1String(id)) return {QKeySequence(QLatin1String(keys))};
  }
  const auto at = static_cast<std::size_t>(&command - commands_.data());
  QList<QKeySequence> own = built_in_[at];
  // What the preset gives to another command is free for it.
  own.removeIf([&](const QKeySequence& k) {
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return QKeySequence(QLatin1String(pair.second)) == k;
    });
  });
  return own;
}

void KeyBindings::apply() {
  for (const Command& c : commands_) {
    if (c.action == nullptr) continue;
    const auto found = changed_.constFind(c.id);
    QList<QKeySequence> keys = found == changed_.constEnd() ? unchanged(c) : QList<QKeySequence>();
    if (found != changed_.constEnd() && !found->isEmpty()) keys = {*found};
    // Among the unchanged, what the user gave to another command is free for that one.
    if (found == changed_.constEnd()) {
      keys.removeIf([&](const QKeySequence& k) { return changed_.values().contains(k); });
    }
    c.action->setShortcuts(keys);
  }
  Q_EMIT changed();
}

void KeyBindings::save() const {
  QMap<QString, QVariant> kept;
  for (auto it = changed_.begin(); it != changed_.end(); ++it) {
    kept[it.key()] = it.value().toString(QKeySequence::PortableText);
  }
  QSettings settings;
  settings.setValue(kPreset, preset_);
  settings.setValue(kChanged, kept);
}

}  // namespace soffit::ui
