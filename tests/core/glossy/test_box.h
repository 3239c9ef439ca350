// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"

#include <array>

namespace soffit::glossy {

/// The six walls of a box, two triangles each: triangle / 2 is 0 .. 5 for -x, +x, -y, +y, -z, +z.
inline geometry::RayCaster boxCaster(const vec3& lo, const vec3& hi) {
  std::array<vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? hi.x : lo.x, (i & 2U) != 0 ? hi.y : lo.y,
                  (i & 4U) != 0 ? hi.z : lo.z};
  }
  const std::array<uvec3, 12> triangles{uvec3(0, 2, 6), uvec3(0, 6, 4), uvec3(1, 3, 7),
                                        uvec3(1, 7, 5), uvec3(0, 1, 5), uvec3(0, 5, 4),
                                        uvec3(2, 3, 7), uvec3(2, 7, 6), uvec3(0, 1, 3),
                                        uvec3(0, 3, 2), uvec3(4, 5, 7), uvec3(4, 7, 6)};
  return {corners, triangles};
}

/// A large floor at height z.
inline geometry::RayCaster floorCaster(float z) {
  const std::array<vec3, 4> corners{vec3(-1e4F, -1e4F, z), vec3(1e4F, -1e4F, z),
                                    vec3(1e4F, 1e4F, z), vec3(-1e4F, 1e4F, z)};
  const std::array<uvec3, 2> triangles{uvec3(0, 1, 2), uvec3(0, 2, 3)};
  return {corners, triangles};
}

}  // namespace soffit::glossy
