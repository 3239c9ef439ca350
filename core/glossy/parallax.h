// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"

#include <optional>
#include <span>
#include <vector>

/// A cube map is right at its probe alone. Seen from elsewhere, a reflection is looked up toward
/// the place that the reflected ray meets.
namespace soffit::glossy {

/// Distance along the unit direction d to the inside of the box from p in it; nothing from outside.
std::optional<float> distanceToBox(const Box& box, const vec3& p, const vec3& d);

/// Where to look from the probe, and the ratio (distance from p) / (distance from the probe) to the
/// place seen: a lobe of width alpha at p covers what one of alpha times this ratio does there.
struct Lookup {
  vec3 direction{0.0F, 0.0F, 1.0F};  ///< unit
  float width = 1.0F;
};

/// Parallax correction to a room that is a box (Lagarde & Zanuttini 2012): exact for the walls of
/// such a room. From a point outside the box d is returned as it is.
Lookup throughBox(const Box& room, const vec3& probe, const vec3& p, const vec3& d);

/// Distances of the scene from a probe in every direction, for what is no box.
class ProbeDepth {
 public:
  /// distances: 6 side^2 along the texels' directions (core/sh/cube_map.h), metres, infinite where
  /// nothing is.
  ProbeDepth(int side, std::vector<float> distances);

  [[nodiscard]] float toward(const vec3& direction) const;

  /// The place that the ray p + t d meets as far as the probe sees it: the distance impostor of
  /// Szirmay-Kalos et al. 2005, by steps along the ray and bisection of the one in which it goes
  /// behind what the probe sees, 3 % of the distance taken as on the surface. far: where to stop
  /// looking, usually distanceToBox(). What the probe does not see counts as free.
  [[nodiscard]] Lookup throughDepth(const vec3& probe, const vec3& p, const vec3& d,
                                    float far) const;

 private:
  int side_;
  std::vector<float> distances_;
};

}  // namespace soffit::glossy
