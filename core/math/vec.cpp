// SPDX-License-Identifier: MIT
#include "core/math/vec.h"

#include <cmath>

namespace soffit {
namespace {

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
dvec2 cosSin(double angle_deg) {
  const double turns = std::remainder(angle_deg, 360.0);
  if (turns == 0.0) return {1.0, 0.0};
  if (turns == 90.0) return {0.0, 1.0};
  if (turns == -90.0) return {0.0, -1.0};
  if (turns == 180.0 || turns == -180.0) return {-1.0, 0.0};
  const double angle = radians(turns);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

dmat3 rotationXyz(const dvec3& rotation_deg) {
  const dvec2 x = cosSin(rotation_deg.x);
  const dvec2 y = cosSin(rotation_deg.y);
  const dvec2 z = cosSin(rotation_deg.z);
  // GLM's constructor takes columns.
  const dmat3 rx(1, 0, 0, 0, x.x, x.y, 0, -x.y, x.x);
  const dmat3 ry(y.x, 0, -y.y, 0, 1, 0, y.y, 0, y.x);
  const dmat3 rz(z.x, z.y, 0, -z.y, z.x, 0, 0, 0, 1);
  return rz * ry * rx;
}

}  // namespace soffit
