// SPDX-License-Identifier: MIT
#include "core/geometry/ray_caster.h"

#include <algorithm>
#include <cmath>

namespace soffit::geometry {

// A point computed on a triangle, and the plane that the intersector sees, are off by a few
// units in the last place of the largest coordinate in play, wherever the triangle is turned to.
// So the step follows the largest component (256 roundings of 2^-24) and is along the normal,
// where Waechter & Binder (Ray Tracing Gems, ch. 6) step each component by its own ulps: theirs
// is shorter for axis-parallel planes, ours the same for a scene and its rotation. The floor
// serves points near the frame's zero, whose triangles may reach far: 8 micrometres.
vec3 offsetOrigin(const vec3& p, const vec3& n) {
  constexpr float kRelative = 0x1p-16F;
  constexpr float kFloor = 0x1p-17F;
  const float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return p + n * std::max(kFloor, kRelative * largest);
}

}  // namespace soffit::geometry
