// SPDX-License-Identifier: MIT
#include "ui/actions/luminaire_actions.h"

#include "ui/document/luminaire_changes.h"
#include "ui/document/luminaire_clipboard.h"
#include "ui/document/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace soffit::ui {
namespace {

constexpr double kCopyOffset = 0.5;  // m
constexpr double kSamePlace = 1e-3;  // m

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

std::vector<light::Luminaire> selected(const Document& document) {
  std::vector<light::Luminaire> all;
  for (const QString& name : document.selection()) {
    if (const light::Luminaire* luminaire = document.luminaire(name)) all.push_back(*luminaire);
  }
  return all;
}

void add(Document& document, const QString& text, std::vector<light::Luminaire> luminaires) {
  if (luminaires.empty()) return;
  QStringList names;
  document.edit(text, withAdded(*document.scene(), toStd(document.layout()), luminaires, names));
  document.setSelection(names);
}

}  // namespace

void duplicateSelection(Document& document) {
  std::vector<light::Luminaire> copies = selected(document);
  for (light::Luminaire& copy : copies) copy.position.x += kCopyOffset;
  add(document, tr("Duplicate"), std::move(copies));
}

void deleteSelection(Document& document) {
  const QStringList& names = document.selection();
  if (names.isEmpty()) return;
  std::set<std::string> gone;
  for (const QString& name : names) gone.insert(toStd(name));
  scene::Scene next = *document.scene();
  std::erase_if(next.luminaires, [&](const auto& l) { return gone.contains(l.name); });
  for (scene::Layout& layout : next.layouts) {
    std::erase_if(layout.edits, [&](const auto& edit) { return gone.contains(edit.first); });
  }
  document.edit(tr("Delete"), std::move(next));
}

void copySelection(const Document& document) {
  if (!document.selection().isEmpty()) copyLuminaires(selected(document));
}

void cutSelection(Document& document) {
  copySelection(document);
  deleteSelection(document);
}

Result<void> paste(Document& document) {
  std::vector<light::Luminaire> pasted = copiedLuminaires();
  for (const light::Luminaire& luminaire : pasted) {
    for (const std::string& file : filesOf(luminaire)) {
      if (document.hasFile(file)) continue;
      return Error{luminaire.name, "its file " + file + " is not in this project's folder",
                   "Copy the file beside the project first."};
    }
  }
  const auto taken = [&](const dvec3& place) {
    return std::ranges::any_of(document.luminaires(), [&](const auto& l) {
      return glm::length(l.position - place) < kSamePlace;
    });
  };
  while (std::ranges::any_of(pasted, [&](const auto& l) { return taken(l.position); })) {
    for (light::Luminaire& luminaire : pasted) luminaire.position.x += kCopyOffset;
  }
  add(document, tr("Paste"), std::move(pasted));
  return {};
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

void dimSelection(Document& document, double dimming) {
  document.editLuminaires(tr("Dim"), document.selection(),
                          [dimming](light::Luminaire& l) { l.dimming = dimming; });
}

void selectAll(Document& document) {
  QStringList names;
  for (const light::Luminaire& luminaire : document.luminaires()) {
    const QString name = toQt(luminaire.name);
    if (!document.hidden().contains(name)) names.append(name);
  }
  document.setSelection(names);
}

void hideSelection(Document& document) {
  document.setHidden(document.hidden() + document.selection());
}

void hideOthers(Document& document) {
  if (document.selection().isEmpty()) return;
  QStringList others;
  for (const light::Luminaire& luminaire : document.luminaires()) {
    const QString name = toQt(luminaire.name);
    if (!document.selection().contains(name)) others.append(name);
  }
  document.setHidden(others);
}

void showHidden(Document& document) {
  document.setHidden({});
}

}  // namespace soffit::ui
