// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/rng.h"
#include "core/math/vec.h"
#include "core/sh/index.h"
#include "core/sh/sphere_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

/// Directions, coefficients and rotations at random, for the tests of core/sh.
namespace soffit::sh {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Random directions, the six axes and directions within rounding of the poles.
inline std::vector<dvec3> testDirections(int n, std::uint64_t seed) {
  std::vector<dvec3> directions = randomSamples(n, seed).directions;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      dvec3 d(0.0);
      d[axis] = sign;
      directions.push_back(d);
      directions.push_back(glm::normalize(d + dvec3(1e-9, -2e-9, 3e-9)));
    }
  }
  return directions;
}

inline Coefficients randomCoefficients(int bands, Rng& rng) {
  Coefficients c(coefficientCount(bands));
  for (double& value : c) value = 2.0 * rng.uniformDouble() - 1.0;
  return c;
}

inline dvec3 randomDirection(Rng& rng) {
  return randomSamples(1, rng.next()).directions[0];
}

/// Turn by `angle` radians about the unit `axis` (Rodrigues).
inline dmat3 turnAbout(const dvec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const dmat3 cross(0, axis.z, -axis.y, -axis.z, 0, axis.x, axis.y, -axis.x, 0);
  return c * dmat3(1.0) + s * cross + (1.0 - c) * glm::outerProduct(axis, axis);
}

inline double largest(std::span<const double> values) {
  double m = 0.0;
  for (const double v : values) m = std::max(m, std::abs(v));
  return m;
}

inline double largestDifference(std::span<const double> a, std::span<const double> b) {
  double m = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    m = std::max(m, std::abs(a[i] - b[i]));
  }
  return m;
}

}  // namespace soffit::sh
