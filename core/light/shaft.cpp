// SPDX-License-Identifier: MIT
#include "core/light/shaft.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::light {

Shaft::Shaft(const Box& from, const Box& to) : from_(from), to_(to) {
  Box hull = from;
  hull.add(to);
  const float reach = std::max(glm::length(hull.lo), glm::length(hull.hi));
  // Rounding of the corner coordinates themselves. Planes start at `from`, so that what is near it
  // has its rounding alone, however far the other box is: with the sun's, 2 cm of a wall would not
  // count.
  const float near = std::max(glm::length(from.lo), glm::length(from.hi));
  tolerance_ = 4e-7F * std::min(reach + hull.diagonal(), 16.0F + 4.0F * near);
  for (int axis = 0; axis < 3; ++axis) {
    vec3 n(0.0F);
    n[axis] = 1.0F;
    addPlane(n, hull.hi[axis]);
    n[axis] = -1.0F;
    addPlane(n, -hull.lo[axis]);
  }
  // In each coordinate plane and each of its quadrants (sx, sy): where one box reaches farther in
  // x and the other farther in y, the edge that bridges their corners is a plane of the hull.
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    for (const float sx : {-1.0F, 1.0F}) {
      for (const float sy : {-1.0F, 1.0F}) {
        const auto corner = [&](const Box& b) {
          return vec2(sx > 0 ? b.hi[x] : b.lo[x], sy > 0 ? b.hi[y] : b.lo[y]);
        };
        const vec2 a = corner(from);
        const vec2 b = corner(to);
        const float dx = sx * (b.x - a.x);
        const float dy = sy * (b.y - a.y);
        if (dx * dy >= 0.0F) continue;
        // Outward normal in the quadrant, perpendicular to b - a.
        const vec2 n = glm::normalize(vec2(sx * std::abs(dy), sy * std::abs(dx)));
        vec3 n3(0.0F);
        n3[x] = n.x;
        n3[y] = n.y;
        addPlane(n3, n.x * a.x + n.y * a.y);
      }
    }
  }
}

void Shaft::addPlane(const vec3& n, float d) {
  assert(count_ < kMaxPlanes);
  if (count_ < kMaxPlanes) planes_[static_cast<std::size_t>(count_++)] = vec4(n, d - tolerance_);
}

bool Shaft::touches(const Box& box) const {
  for (int i = 0; i < count_; ++i) {
    const vec4& p = planes_[static_cast<std::size_t>(i)];
    const vec3 nearest(p.x > 0 ? box.lo.x : box.hi.x, p.y > 0 ? box.lo.y : box.hi.y, p.z > 0 ? box.lo.z : box.hi.z);
    if (p.x * nearest.x + p.y * nearest.y + p.z * nearest.z >= p.w) return false;
  }
  return true;
}

bool Shaft::touches(std::span<const vec3> corners) const {
  for (int i = 0; i < count_; ++i) {
    const vec4& p = planes_[static_cast<std::size_t>(i)];
    bool outside = true;
    for (const vec3& c : corners) {
      if (p.x * c.x + p.y * c.y + p.z * c.z < p.w) {
        outside = false;
        break;
      }
    }
    if (outside) return false;
  }
  return true;
}

}  // namespace soffit::light
