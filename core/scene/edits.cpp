// SPDX-License-Identifier: MIT
#include "core/scene/edits.h"

#include "core/scene/equality.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soffit::scene {
namespace {

template <class T>
void assign(T& field, const std::optional<T>& edit) {
  if (edit) field = *edit;
}

template <class T>
void assign(std::optional<T>& field, const std::optional<T>& edit) {
  if (edit) field = edit;
}

Layout* findLayout(Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.layouts, name, &Layout::name);
  return found == scene.layouts.end() ? nullptr : &*found;
}

Error noLayout(const Scene& scene, std::string_view name) {
  std::string known;
  for (const Layout& layout : scene.layouts) known += (known.empty() ? "" : ", ") + layout.name;
  return {"layouts", fmt::format("there is no layout named '{}'", name),
          known.empty() ? "The project has no layouts." : fmt::format("Choose one of: {}.", known)};
}

Error noLuminaire(std::string_view name) {
  return {"luminaires", fmt::format("there is no luminaire named '{}'", name),
          "Check the spelling, or add it first."};
}

bool isTaken(const Scene& scene, std::string_view name) {
  if (findLuminaire(scene, name) != nullptr) return true;
  return std::ranges::any_of(scene.layouts, [&](const Layout& layout) {
    return layout.edits.contains(std::string(name));
  });
}

/// An error when `name` cannot be given to a new luminaire.
Result<void> checkNewName(const Scene& scene, std::string_view name) {
  if (name.empty()) return Error{"luminaires", "the name is empty", "Give the luminaire a name."};
  if (isTaken(scene, name)) {
    return Error{"luminaires", fmt::format("the name '{}' is taken", name), "Choose another name."};
  }
  return {};
}

/// Fields of `later` win over those of `earlier`.
LuminaireEdit combined(const LuminaireEdit& earlier, const LuminaireEdit& later) {
  LuminaireEdit sum = earlier;
  assign(sum.shape, later.shape);
  assign(sum.position, later.position);
  assign(sum.rotation_deg, later.rotation_deg);
  assign(sum.scale, later.scale);
  assign(sum.flux, later.flux);
  assign(sum.colour, later.colour);
  assign(sum.distribution, later.distribution);
  assign(sum.casts_shadow, later.casts_shadow);
  assign(sum.dimming, later.dimming);
  assign(sum.on, later.on);
  assign(sum.group, later.group);
  return sum;
}

}  // namespace

light::Luminaire applyEdit(const light::Luminaire& luminaire, const LuminaireEdit& edit) {
  light::Luminaire edited = luminaire;
  assign(edited.shape, edit.shape);
  assign(edited.position, edit.position);
  assign(edited.rotation_deg, edit.rotation_deg);
  assign(edited.scale, edit.scale);
  assign(edited.flux, edit.flux);
  assign(edited.colour, edit.colour);
  assign(edited.distribution, edit.distribution);
  assign(edited.casts_shadow, edit.casts_shadow);
  assign(edited.dimming, edit.dimming);
  assign(edited.on, edit.on);
  assign(edited.group, edit.group);
  return edited;
}

LuminaireEdit editBetween(const light::Luminaire& from, const light::Luminaire& to) {
  LuminaireEdit edit;
  if (!same(from.shape, to.shape)) edit.shape = to.shape;
  if (from.position != to.position) edit.position = to.position;
  if (from.rotation_deg != to.rotation_deg) edit.rotation_deg = to.rotation_deg;
  if (from.scale != to.scale) edit.scale = to.scale;
  if (from.flux != to.flux) edit.flux = to.flux;
  if (!same(from.colour, to.colour)) edit.colour = to.colour;
  if (!same(from.distribution, to.distribution)) edit.distribution = to.distribution;
  if (from.casts_shadow != to.casts_shadow) edit.casts_shadow = to.casts_shadow;
  if (from.dimming != to.dimming) edit.dimming = to.dimming;
  if (from.on != to.on) edit.on = to.on;
  if (from.group != to.group) edit.group = to.group;
  return edit;
}

bool isEmpty(const LuminaireEdit& edit) {
  return same(edit, LuminaireEdit{});
}

const Layout* findLayout(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.layouts, name, &Layout::name);
  return found == scene.layouts.end() ? nullptr : &*found;
}

const light::Luminaire* findLuminaire(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.luminaires, name, &light::Luminaire::name);
  return found == scene.luminaires.end() ? nullptr : &*found;
}

Result<Scene> withEdit(const Scene& scene, std::string_view layout, std::string_view luminaire,
                       const LuminaireEdit& edit) {
  Scene edited = scene;
  if (layout.empty()) {
    const auto found = std::ranges::find(edited.luminaires, luminaire, &light::Luminaire::name);
    if (found == edited.luminaires.end()) return noLuminaire(luminaire);
    *found = applyEdit(*found, edit);
    return edited;
  }
  Layout* target = findLayout(edited, layout);
  if (target == nullptr) return noLayout(scene, layout);
  const std::string name(luminaire);
  if (findLuminaire(scene, name) == nullptr && !target->edits.contains(name)) {
    return noLuminaire(luminaire);
  }
  target->edits[name] = combined(target->edits[name], edit);
  return edited;
}

Result<Scene> withLuminaire(const Scene& scene, std::string_view layout,
                            const light::Luminaire& luminaire) {
  if (const auto free = checkNewName(scene, luminaire.name); !free) return free.error();
  Scene edited = scene;
  if (layout.empty()) {
    edited.luminaires.push_back(luminaire);
    return edited;
  }
  Layout* target = findLayout(edited, layout);
  if (target == nullptr) return noLayout(scene, layout);
  light::Luminaire defaults;
  defaults.name = luminaire.name;
  target->edits[luminaire.name] = editBetween(defaults, luminaire);
  return edited;
}

Result<Scene> withoutLuminaire(const Scene& scene, std::string_view luminaire) {
  if (!isTaken(scene, luminaire)) return noLuminaire(luminaire);
  Scene edited = scene;
  std::erase_if(edited.luminaires, [&](const auto& entry) { return entry.name == luminaire; });
  for (Layout& layout : edited.layouts) layout.edits.erase(std::string(luminaire));
  return edited;
}

Result<Scene> withLuminaireRenamed(const Scene& scene, std::string_view from, std::string_view to) {
  if (!isTaken(scene, from)) return noLuminaire(from);
  if (from == to) return scene;
  if (const auto free = checkNewName(scene, to); !free) return free.error();
  Scene edited = scene;
  for (light::Luminaire& entry : edited.luminaires) {
    if (entry.name == from) entry.name = to;
  }
  for (Layout& layout : edited.layouts) {
    auto node = layout.edits.extract(std::string(from));
    if (node.empty()) continue;
    node.key() = to;
    layout.edits.insert(std::move(node));
  }
  return edited;
}

Result<Scene> withLayout(const Scene& scene, std::string_view name, std::string_view source) {
  if (name.empty()) return Error{"layouts", "the name is empty", "Give the layout a name."};
  if (findLayout(scene, name) != nullptr) {
    return Error{"layouts", fmt::format("the name '{}' is taken", name), "Choose another name."};
  }
  Layout added;
  if (!source.empty()) {
    const Layout* from = findLayout(scene, source);
    if (from == nullptr) return noLayout(scene, source);
    added = *from;
  }
  added.name = name;
  Scene edited = scene;
  edited.layouts.push_back(std::move(added));
  return edited;
}

std::string freeLuminaireName(const Scene& scene, std::string_view stem) {
  std::string name(stem);
  for (int number = 2; name.empty() || isTaken(scene, name); ++number) {
    name = fmt::format("{} {}", stem.empty() ? "Luminaire" : stem, number);
  }
  return name;
}

}  // namespace soffit::scene
