// SPDX-License-Identifier: MIT
#include "ui/actions/luminaire_actions.h"

#include "ui/document/text.h"

#include <QCoreApplication>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr double kCopyOffset = 0.5;  // m

QString tr(const char* text) {
  return QCoreApplication::translate("LuminaireActions", text);
}

/// "Panel 3" without its number, so that copies are numbered on.
std::string stemOf(const std::string& name) {
  const auto end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size() || name[end] != ' ') return name;
  return name.substr(0, end);
}

}  // namespace

void duplicateSelection(Document& document) {
  scene::Scene next = *document.scene();
  QStringList copies;
  for (const QString& name : document.selection()) {
    const light::Luminaire* original = document.luminaire(name);
    if (original == nullptr) continue;
    light::Luminaire copy = *original;
    copy.name = scene::freeLuminaireName(next, stemOf(original->name));
    copy.position.x += kCopyOffset;
    auto with = scene::withLuminaire(next, toStd(document.layout()), copy);
    if (!with) continue;
    next = std::move(*with);
    copies.append(toQt(copy.name));
  }
  if (copies.isEmpty()) return;
  document.edit(tr("Duplicate"), std::move(next));
  document.setSelection(copies);
}

void deleteSelection(Document& document) {
  scene::Scene next = *document.scene();
  const QStringList names = document.selection();
  for (const QString& name : names) {
    auto without = scene::withoutLuminaire(next, toStd(name));
    if (without) next = std::move(*without);
  }
  if (!names.isEmpty()) document.edit(tr("Delete"), std::move(next));
}

void toggleSelection(Document& document) {
  const QStringList names = document.selection();
  const bool on = std::ranges::any_of(names, [&](const QString& name) {
    const light::Luminaire* luminaire = document.luminaire(name);
    return luminaire != nullptr && !luminaire->on;
  });
  document.editLuminaires(on ? tr("Switch on") : tr("Switch off"), names,
                          [on](light::Luminaire& l) { l.on = on; });
}

void selectAll(Document& document) {
  QStringList names;
  for (const light::Luminaire& luminaire : document.luminaires())
    names.append(toQt(luminaire.name));
  document.setSelection(names);
}

}  // namespace soffit::ui
