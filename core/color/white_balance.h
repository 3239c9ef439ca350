// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// What eyes and cameras that have adapted to a light take for white.
namespace soffit::color {

/// Temperatures that a white may have, kelvin.
inline constexpr double kCoolestWhite = 25000.0;
inline constexpr double kWarmestWhite = 1500.0;

/// Linear Rec.709 as it looks under daylight (D65) to somebody who sees it in light of this colour
/// temperature: what a black body of `kelvin` makes white becomes (1, 1, 1), at the same luminance.
/// Von Kries' rule on the cone responses of Lam 1985 ("Bradford"; ICC.1:2022, annex E, eq. E.1).
/// Identity for kelvin <= 0. Bounds: kWarmestWhite .. kCoolestWhite.
///
/// Saturated colours may become negative (outside of Rec.709): the caller clips.
dmat3 whiteBalance(double kelvin);

/// The colour temperature whose black body is nearest to a colour in CIE 1960 u, v (the definition
/// of correlated colour temperature, CIE 15), kWarmestWhite .. kCoolestWhite, within 1 K on the
/// Planckian locus. xyz: Y > 0.
double correlatedTemperature(const dvec3& xyz);

}  // namespace soffit::color
