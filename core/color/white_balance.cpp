// SPDX-License-Identifier: MIT
#include "core/color/white_balance.h"

#include "core/color/cct.h"

#include <algorithm>
#include <cmath>

namespace soffit::color {
namespace {

/// Rows: long, middle and short cones from CIE XYZ.
dmat3 conesFromXyz() {
  return glm::transpose(
      dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
}

/// CIE 1960 uniform chromaticity.
dvec2 uvOf(const dvec3& xyz) {
  const double sum = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
  return {4.0 * xyz.x / sum, 6.0 * xyz.y / sum};
}

}  // namespace

dmat3 whiteBalance(double kelvin) {
  if (!(kelvin > 0.0)) return dmat3(1.0);
  const auto columns = [](dvec3 (*map)(const dvec3&)) {
    return dmat3(map({1.0, 0.0, 0.0}), map({0.0, 1.0, 0.0}), map({0.0, 0.0, 1.0}));
  };
  const dmat3 to_rec709 = columns(rec709FromXyz);
  const dmat3 to_xyz = columns(xyzFromRec709);
  const dmat3 cones = conesFromXyz();
  const dvec3 white = cones * planckianXyz(std::clamp(kelvin, kWarmestWhite, kCoolestWhite));
  const dvec3 daylight = cones * (to_xyz * dvec3(1.0));
  dmat3 scale(0.0);
  for (int i = 0; i < 3; ++i) scale[i][i] = daylight[i] / white[i];
  return to_rec709 * glm::inverse(cones) * scale * cones * to_xyz;
}

double correlatedTemperature(const dvec3& xyz) {
  const dvec2 wanted = uvOf(xyz);
  // Steps along the locus are nearly even in reciprocal temperature.
  const auto distance = [&](double mired) {
    const dvec2 d = uvOf(planckianXyz(1e6 / mired)) - wanted;
    return glm::dot(d, d);
  };
  const double least = 1e6 / kCoolestWhite;
  const double most = 1e6 / kWarmestWhite;
  constexpr int kSteps = 64;
  const double step = (most - least) / kSteps;
  double best = least;
  for (int i = 1; i <= kSteps; ++i) {
    const double at = least + i * step;
    if (distance(at) < distance(best)) best = at;
  }
  // Golden section between its neighbours.
  double a = std::max(least, best - step);
  double b = std::min(most, best + step);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (b - a > 0.002) {
    const double c = b - golden * (b - a);
    const double d = a + golden * (b - a);
    if (distance(c) < distance(d)) {
      b = d;
    } else {
      a = c;
    }
  }
  return 1e6 / (0.5 * (a + b));
}

}  // namespace soffit::color
