// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>

/// The GGX lobe as two factors: how much it reflects, and a lobe of unit weight that is round about
/// one direction, so that it can be applied to SH coefficients, cube maps and lookups.
///
/// Light reflected toward wo ~ (f0 scale + bias) / above * integral over the upper half of L times
/// the round lobe. The first factor is exact under uniform light (split sum; Karis 2013). The round
/// lobe is the reflected GGX lobe about the axis and of the alpha with which, cut off at the
/// surface, it has the mean direction and the mean cosine of the true one (which off the normal is
/// neither round nor about the mirror direction, least of all at grazing angles); `above` is the
/// share of it that is left. So it is exact under light that varies linearly with direction.
namespace soffit::glossy {

struct LobeShape {
  double scale = 1.0;      ///< of f0
  double bias = 0.0;       ///< for f0 = 0: reflectance is f0 scale + bias
  double axis_sine = 0.0;  ///< sine of its axis's angle from the normal
  double alpha = 0.25;     ///< of the round lobe
  double above = 1.0;      ///< share of the round lobe above the surface

  [[nodiscard]] double reflectance(double f0) const { return f0 * scale + bias; }
};

/// Below this alpha the lobe is a mirror (core/render/microfacet.h).
inline constexpr double kMirrorAlpha = 1.0e-3;

/// Integrals over 256 x 256 directions: reflectances within 2e-4. cos_view in (0, 1], alpha in
/// [kMirrorAlpha, 1].
LobeShape integrateLobe(double cos_view, double alpha);

/// The same from a table of 33 x 33 (made once, on all threads, in about 1 s of one core): against
/// integrateLobe() at cos_view >= 0.02 scale and bias are within 0.005 (at grazing angles; 0.001
/// elsewhere), axis_sine within 0.015, alpha within 2 %, above within 0.02. Mirrors are exact;
/// cos_view and alpha are clamped to their ranges.
LobeShape lobeShape(double cos_view, double alpha);

/// The axis of the lobe for light that leaves toward `to_eye` over the unit normal.
vec3 lobeAxis(const LobeShape& shape, const vec3& normal, const vec3& to_eye);

/// k_l of the reflected lobe for degrees 0 .. 9, from a table over alpha: within 0.01, the error of
/// alpha rounded to 1/1024.
const std::array<float, 10>& lobeKernel(double alpha);

}  // namespace soffit::glossy
