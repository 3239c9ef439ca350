// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <cmath>
#include <cstddef>
#include <vector>

/// How far the static scene is from a probe, in every direction: the depth that lights are drawn
/// against. Made once per probe; lights move, walls do not.
namespace soffit::light {

/// Distances along the unit directions of a cube map's texel centres (layout: core/sh/cube_map.h).
struct DepthCube {
  dvec3 probe{0.0};             ///< relative to the scene origin
  int side = 0;                 ///< texels along an edge of a face
  std::vector<float> distance;  ///< metres, 6 side^2; infinity where nothing is hit

  /// Is a point at `distance_m` along the centre of texel `index` hidden? What lies within 1 mm or
  /// 1 part in 1000 behind the surface counts as on it: a luminaire that is let into a ceiling.
  [[nodiscard]] bool hides(std::size_t index, double distance_m) const {
    const auto depth = static_cast<double>(distance[index]);
    return distance_m > depth + std::fmax(1e-3, 1e-3 * depth);
  }
};

/// One ray per texel, in packets; side >= 1. The probe must not lie on a surface.
DepthCube makeDepthCube(const geometry::RayCaster& scene, const dvec3& probe, int side);

}  // namespace soffit::light
