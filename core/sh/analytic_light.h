// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"

/// The tutorial's light without a photograph (Green 2003; Slomp, Oliveira, Patricio):
/// max(0, 5 cos theta - 4) + max(0, -4 sin(theta - pi) cos(phi - 2.5) - 3): a bright patch overhead
/// and one on the horizon.
namespace soffit::sh {

/// Both terms are max(0, gain (d . axis) - threshold); the defaults are the tutorial's numbers. For
/// the second, -sin(theta - pi) cos(phi - 2.5) = sin theta cos(phi - 2.5) = d . (cos 2.5, sin 2.5,
/// 0).
struct AnalyticLight {
  double overhead_gain = 5.0;
  double overhead_threshold = 4.0;
  double side_gain = 4.0;
  double side_threshold = 3.0;
  double side_azimuth = 2.5;  ///< radians from +x towards +y
  double scale = 1.0;         ///< cd/m^2 per unit of the formula

  /// Radiance from the unit direction d (z up), unit that of `scale`.
  [[nodiscard]] double operator()(const dvec3& d) const;
};

/// Its coefficients, exact up to rounding: each term is a zonal function, linear beside its jump of
/// slope. Gains and thresholds are finite; a gain below 0 turns a patch to the other side.
Coefficients analyticCoefficients(const AnalyticLight& light, int bands);

}  // namespace soffit::sh
