// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "core/math/vec.h"

namespace soffit::geometry {

/// Axis-aligned box in double precision; empty (inverted) when default-constructed.
struct DoubleBox {
  dvec3 lo{std::numeric_limits<double>::infinity()};
  dvec3 hi{-std::numeric_limits<double>::infinity()};
  void add(const dvec3& p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
};

/// Where the frame of a mesh with these bounds (metres, world) has its zero: (0,0,0), or, for a
/// model that lies farther out than 10 km, or than 1 km and 100 times its diagonal, its center in
/// whole metres, so that single precision resolves it as well as one at the world's zero.
inline dvec3 chooseOrigin(const DoubleBox& box) {
  if (box.lo.x > box.hi.x) return dvec3(0.0);
  constexpr double kFar = 10e3;
  constexpr double kNear = 1e3;
  const dvec3 center = 0.5 * (box.lo + box.hi);
  const double distance = glm::length(center);
  const double diagonal = glm::length(box.hi - box.lo);
  const bool outlying = distance > kFar || (distance > kNear && distance > 100.0 * diagonal);
  return outlying ? glm::round(center) : dvec3(0.0);
}

}  // namespace soffit::geometry
