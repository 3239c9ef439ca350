// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_changes.h"

#include "ui/document/text.h"

#include <algorithm>
#include <set>
#include <utility>

namespace soffit::ui {
namespace {

scene::Layout* layoutOf(scene::Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.layouts, name, &scene::Layout::name);
  return found == scene.layouts.end() ? nullptr : &*found;
}

/// Fields of `later` added to those that a layout names already.
void addFields(scene::LuminaireEdit& edit, const scene::LuminaireEdit& later) {
  const auto take = [](auto& field, const auto& from) {
    if (from) field = from;
  };
  take(edit.shape, later.shape);
  take(edit.position, later.position);
  take(edit.rotation_deg, later.rotation_deg);
  take(edit.scale, later.scale);
  take(edit.flux, later.flux);
  take(edit.colour, later.colour);
  take(edit.distribution, later.distribution);
  take(edit.casts_shadow, later.casts_shadow);
  take(edit.dimming, later.dimming);
  take(edit.on, later.on);
  take(edit.group, later.group);
}

std::set<std::string> takenNames(const scene::Scene& scene) {
  std::set<std::string> taken;
  for (const light::Luminaire& l : scene.luminaires) taken.insert(l.name);
  for (const scene::Layout& layout : scene.layouts) {
    for (const auto& [name, edit] : layout.edits) taken.insert(name);
  }
  return taken;
}

std::string freeName(std::set<std::string>& taken, const std::string& wanted) {
  std::string name = wanted.empty() ? "Luminaire" : wanted;
  const std::string stem = stemOf(name);
  for (int number = 2; taken.contains(name); ++number) {
    name = stem + ' ' + std::to_string(number);
  }
  taken.insert(name);
  return name;
}

}  // namespace

std::vector<light::Luminaire> luminairesOf(const scene::Scene& scene, const std::string& layout) {
  const scene::Layout* found = scene::findLayout(scene, layout);
  return found == nullptr ? scene.luminaires : scene::resolveLayout(scene, *found);
}

scene::Scene withChanged(const scene::Scene& scene, const std::string& layout,
                         const QStringList& names,
                         const std::function<void(light::Luminaire&)>& change) {
  scene::Scene next = scene;
  const std::set<QString> wanted(names.begin(), names.end());
  scene::Layout* target = layoutOf(next, layout);
  if (target == nullptr) {
    for (light::Luminaire& luminaire : next.luminaires) {
      if (!wanted.contains(toQt(luminaire.name))) continue;
      std::string name = luminaire.name;
      change(luminaire);
      luminaire.name = std::move(name);
    }
    return next;
  }
  for (const light::Luminaire& luminaire : luminairesOf(scene, layout)) {
    if (!wanted.contains(toQt(luminaire.name))) continue;
    light::Luminaire changed = luminaire;
    change(changed);
    const scene::LuminaireEdit edit = scene::editBetween(luminaire, changed);
    if (!scene::isEmpty(edit)) addFields(target->edits[luminaire.name], edit);
  }
  return next;
}

scene::Scene withAdded(const scene::Scene& scene, const std::string& layout,
                       std::span<const light::Luminaire> added, QStringList& names) {
  scene::Scene next = scene;
  std::set<std::string> taken = takenNames(scene);
  scene::Layout* target = layoutOf(next, layout);
  for (const light::Luminaire& luminaire : added) {
    light::Luminaire one = luminaire;
    one.name = freeName(taken, luminaire.name);
    names.append(toQt(one.name));
    if (target == nullptr) {
      next.luminaires.push_back(std::move(one));
      continue;
    }
    light::Luminaire blank;
    blank.name = one.name;
    scene::LuminaireEdit edit = scene::editBetween(blank, one);
    // A layout's own luminaire says what it is, even where it is like the default.
    edit.shape = one.shape;
    edit.position = one.position;
    target->edits[one.name] = std::move(edit);
  }
  return next;
}

std::string stemOf(const std::string& name) {
  const auto end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size() || name[end] != ' ') return name;
  return name.substr(0, end);
}

}  // namespace soffit::ui
