// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>

/// From luminance to the scene-linear values that view transforms work on.
namespace soffit::color {

/// The luminance that becomes scene-linear 1 at exposure 0, cd/m^2 (interfaces.md, View).
inline constexpr double kReferenceLuminance = 100.0;

/// Mid grey of every view: the scene-linear value that an average picture should have.
inline constexpr double kMidGrey = 0.18;

/// 2^ev / kReferenceLuminance: multiplies cd/m^2.
float exposureScale(double exposure_ev);

/// The exposure in EV that brings the log-average luminance of a picture to kMidGrey.
///
/// radiance  linear Rec.709, cd/m^2; pixels that are black, negative or not finite are left out,
///           and the brightest percent (luminaires) too.
/// return    EV, within -20..20; 0 when no pixel is lit.
/// Source: Reinhard et al. 2002, "Photographic Tone Reproduction", eq. 1 and 2.
double autoExposure(std::span<const vec3> radiance);

}  // namespace soffit::color
