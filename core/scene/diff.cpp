// SPDX-License-Identifier: MIT
#include "core/scene/diff.h"

#include "core/scene/equality.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace soffit::scene {
namespace {

using LuminaireMap = std::map<std::string_view, const light::Luminaire*>;

LuminaireMap byName(std::span<const light::Luminaire> luminaires) {
  LuminaireMap map;
  for (const light::Luminaire& luminaire : luminaires) map.emplace(luminaire.name, &luminaire);
  return map;
}

LuminaireChange changeBetween(const light::Luminaire& a, const light::Luminaire& b) {
  LuminaireChange change;
  change.name = b.name;
  change.moved = a.position != b.position || a.rotation_deg != b.rotation_deg;
  change.reshaped = a.scale != b.scale || !same(a.shape, b.shape);
  change.photometry = !same(a.distribution, b.distribution);
  change.flux = a.flux != b.flux;
  change.casts_shadow = a.casts_shadow != b.casts_shadow;
  // A light that is off has no dimming to speak of: only the product counts.
  change.gain = (a.on ? a.dimming : 0.0) != (b.on ? b.dimming : 0.0);
  change.color = !same(a.colour, b.colour);
  change.group = a.group != b.group;
  return change;
}

bool sameGeometry(const Scene& a, const Scene& b) {
  if (a.mesh != b.mesh) {
    if (a.mesh == nullptr || b.mesh == nullptr || !same(*a.mesh, *b.mesh)) return false;
  }
  return std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name);
}

bool sameEnvironment(const Scene& a, const Scene& b) {
  if (a.environment.has_value() != b.environment.has_value()) return false;
  return !a.environment || (a.environment->description == b.environment->description &&
                            same(*a.environment, *b.environment));
}

}  // namespace

std::vector<LuminaireChange> diffLuminaires(std::span<const light::Luminaire> before,
                                            std::span<const light::Luminaire> after) {
  std::vector<LuminaireChange> changes;
  const LuminaireMap earlier = byName(before);
  for (const light::Luminaire& luminaire : after) {
    const auto found = earlier.find(luminaire.name);
    LuminaireChange change;
    if (found == earlier.end()) {
      change.name = luminaire.name;
      change.added = true;
    } else {
      change = changeBetween(*found->second, luminaire);
    }
    if (change.any()) changes.push_back(change);
  }
  const LuminaireMap later = byName(after);
  for (const light::Luminaire& luminaire : before) {
    if (later.contains(luminaire.name)) continue;
    LuminaireChange change;
    change.name = luminaire.name;
    change.removed = true;
    changes.push_back(change);
  }
  return changes;
}

SceneDiff diff(const Scene& before, const Scene& after) {
  SceneDiff d;
  d.geometry = !sameGeometry(before, after);
  for (std::size_t i = 0; i < after.materials.size(); ++i) {
    if (i >= before.materials.size() || !sameReflectance(before.materials[i], after.materials[i])) {
      d.reflectances.push_back(i);
    }
  }
  d.luminaires = diffLuminaires(before.luminaires, after.luminaires);
  d.layouts = !sameList(before.layouts, after.layouts);
  d.cameras = !sameList(before.cameras, after.cameras);
  d.work_planes = !sameList(before.work_planes, after.work_planes);
  d.environment = !sameEnvironment(before, after);
  d.view = !same(before.view, after.view);
  d.quality = !same(before.quality, after.quality);
  d.name = before.name != after.name;
  return d;
}

}  // namespace soffit::scene
