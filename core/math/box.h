// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <limits>

namespace soffit {

/// Axis-aligned box; empty (inverted) when default-constructed.
struct Box {
  vec3 lo{std::numeric_limits<float>::infinity()};
  vec3 hi{-std::numeric_limits<float>::infinity()};

  void add(const vec3& p) { lo = glm::min(lo, p); hi = glm::max(hi, p); }
  void add(const Box& b) { lo = glm::min(lo, b.lo); hi = glm::max(hi, b.hi); }
  [[nodiscard]] bool empty() const { return lo.x > hi.x; }
  [[nodiscard]] vec3 center() const { return 0.5F * (lo + hi); }
  [[nodiscard]] vec3 size() const { return hi - lo; }
  [[nodiscard]] float diagonal() const { return empty() ? 0.0F : glm::length(hi - lo); }
  [[nodiscard]] bool contains(const vec3& p) const {
    return p.x >= lo.x && p.y >= lo.y && p.z >= lo.z && p.x <= hi.x && p.y <= hi.y && p.z <= hi.z;
  }
  [[nodiscard]] bool overlaps(const Box& b) const {
    return lo.x <= b.hi.x && b.lo.x <= hi.x && lo.y <= b.hi.y && b.lo.y <= hi.y && lo.z <= b.hi.z && b.lo.z <= hi.z;
  }
  /// Squared distance of a point to the box, 0 inside.
  [[nodiscard]] float distanceSquared(const vec3& p) const {
    const vec3 d = glm::max(glm::max(lo - p, p - hi), vec3(0));
    return glm::dot(d, d);
  }
};

}  // namespace soffit
