// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstddef>
#include <span>

/// The GGX lobe as two round lobes of unit weight with factors, so that it can be applied to SH
/// coefficients, cube maps and lookups.
///
/// Schlick's F = f0 + (1 - f0) rise parts the lobe: f0 times (1 - rise), and rise. Light reflected
/// toward wo ~ f0 scale <L>_base + bias <L>_rise, where <L> is the mean of the light above the
/// surface weighted by a round lobe. The factors are exact under uniform light (split sum; Karis
/// 2013). Each round lobe is a reflected GGX lobe about the axis and of the alpha with which, cut
/// off at the surface, it has the mean direction and the mean cosine of its part of the true one:
/// so the sum is exact under light that varies linearly with direction. One lobe for both would be
/// wrong by a third at grazing light: the rise of a rough surface of f0 = 0.04 looks 20 degrees
/// above the horizon where the rest looks 45.
namespace soffit::glossy {

struct RoundLobe {
  double axis_sine = 0.0;  ///< sine of its axis's angle from the normal
  double alpha = 0.25;
  double above = 1.0;  ///< share of it above the surface: what <L> is divided by
};

struct LobeShape {
  double scale = 1.0;  ///< of f0
  double bias = 0.0;   ///< for f0 = 0
  RoundLobe base, rise;

  /// Of uniform light.
  [[nodiscard]] double reflectance(double f0) const { return f0 * scale + bias; }
};

/// Below this alpha the lobe is a mirror (core/render/microfacet.h).
inline constexpr double kMirrorAlpha = 1.0e-3;

/// Integrals over 256 x 256 directions: reflectances within 2e-4. cos_view in (0, 1], alpha in
/// [kMirrorAlpha, 1].
LobeShape integrateLobe(double cos_view, double alpha);

/// The same from a table of 33 x 33 (made once, on all threads, in about 2 s of one core): against
/// integrateLobe() at cos_view >= 0.02 scale and bias are within 0.005 (at grazing angles; 0.001
/// elsewhere), the base's axis_sine within 0.02, its alpha within 6 %, its share above within 0.05;
/// the rise's as well, times its share of the reflectance of f0 = 0.04 (about the normal, where it
/// is a ring, it has nearly none). Mirrors are exact; cos_view and alpha are clamped to their
/// ranges.
LobeShape lobeShape(double cos_view, double alpha);

/// The table behind lobeShape(), for a graphics card, which interpolates as lobeShape() does: node
/// j * nodes + i holds cosine least_cosine + (1 - least_cosine) (i / (nodes - 1))^2 and alpha
/// (least_roughness + (1 - least_roughness) j / (nodes - 1))^2; axis_sine over the mirror
/// direction's sine, alpha over the true one.
struct LobeTable {
  std::size_t nodes = 0;
  double least_cosine = 0.0;
  double least_roughness = 0.0;
  std::span<const LobeShape> shapes;
};
LobeTable lobeTable();

/// The axis of the lobe for light that leaves toward `to_eye` over the unit normal.
vec3 lobeAxis(const RoundLobe& lobe, const vec3& normal, const vec3& to_eye);

/// k_l of the reflected lobe for degrees 0 .. 9, from a table over alpha: within 0.01, the error of
/// alpha rounded to 1/1024.
const std::array<float, 10>& lobeKernel(double alpha);

}  // namespace soffit::glossy
