// SPDX-License-Identifier: MIT
#include "ui/viewport/placement.h"

#include "core/light/emitter.h"
#include "ui/document/luminaire_pose.h"
#include "ui/viewport/gizmo.h"

#include <cmath>

namespace soffit::ui {
namespace {

/// Steeper than 45 degrees is a wall.
constexpr float kLevel = 0.7F;
constexpr double kUnderTheSky = 2.5;  // m
constexpr double kOffSurface = 0.02;  // m, where rays upward start
constexpr double kMillimetre = 1e-3;

double rounded(double v) {
  return std::round(v / kMillimetre) / std::round(1.0 / kMillimetre);
}

void measure(Placement& placement, const Surroundings& around, const glm::bvec3& axes) {
  placement.clearances = clearances(around, placement.luminaire.position, axes);
}

Placement onWall(Placement placement, const SurfaceReading& surface, const Surroundings& around,
                 const PlacementRules& rules, double depth) {
  const dvec3 normal(surface.normal);
  light::Luminaire& luminaire = placement.luminaire;
  luminaire.rotation_deg = aimedAlong(normal, dvec3(0.0));
  if (rules.turn_deg != 0.0) {
    // About its own axis first: the local z of an unrotated luminaire.
    luminaire.rotation_deg = rotationDegOf(rotationXyz(luminaire.rotation_deg) *
                                           rotationXyz({0.0, 0.0, rules.turn_deg}));
  }
  luminaire.position = surface.position + (kCeilingGap + depth) * normal;
  for (int i = 0; i < 3; ++i) luminaire.position[i] = rounded(luminaire.position[i]);
  measure(placement, around, {std::abs(normal.x) < 0.5, std::abs(normal.y) < 0.5, true});
  return placement;
}

}  // namespace

std::optional<double> ceilingAbove(const Surroundings& around, const dvec3& place) {
  const dvec3 from = place + dvec3(0.0, 0.0, kOffSurface);
  const auto up = around.distance(from, axisOf(2));
  if (!up) return std::nullopt;
  return from.z + *up;
}

std::optional<Placement> placeOn(const LuminaireType& type, const SurfaceReading& surface,
                                 const Surroundings& around, const PlacementRules& rules) {
  Placement placement;
  placement.luminaire = type.prototype;
  light::Luminaire& luminaire = placement.luminaire;
  luminaire.rotation_deg = dvec3(0.0, 0.0, rules.turn_deg);
  const auto emitter = light::makeEmitter(luminaire);
  if (!emitter) return std::nullopt;
  const bool empty = emitter->bounds.empty();
  const double top = empty ? 0.0 : static_cast<double>(emitter->bounds.hi.z);
  if (std::abs(surface.normal.z) < kLevel) {
    return onWall(std::move(placement), surface, around, rules, top);
  }
  dvec3 place = surface.position;
  if (surface.normal.z > 0.0F) {
    place.z = ceilingAbove(around, place).value_or(place.z + kUnderTheSky);
  }
  place.z -= kCeilingGap + top + type.drop;
  const dvec3 half = empty ? dvec3(0.0) : dvec3(glm::max(emitter->bounds.hi, -emitter->bounds.lo));
  const Snapped snapped = snap(around, rules.snap, place, {true, true, false}, half, rules.reach);
  luminaire.position = {rounded(snapped.place.x), rounded(snapped.place.y), rounded(place.z)};
  placement.guides = snapped.guides;
  // From what is pointed at up to where it hangs.
  placement.guides.push_back({surface.position, luminaire.position});
  measure(placement, around, {true, true, false});
  return placement;
}

}  // namespace soffit::ui
