// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/intensity_distribution.h"

/// Beam and field angle: how wide the light opens in a plane through the luminaire's axis.
namespace soffit::photometry {

/// Of which intensity the half (beam) and the tenth (field) are taken.
enum class BeamReference {
  peak,    ///< CIE S 017: the greatest intensity of the plane
  centre,  ///< IES (ANSI C78.379, "centre-beam candlepower"): the intensity on the axis
};

inline constexpr double kBeamShare = 0.5;
inline constexpr double kFieldShare = 0.1;

/// Full angle in degrees, 0..360, in the plane through c_deg and c_deg + 180, between the outermost
/// directions with at least `share` of the reference intensity.
///
/// The axis is gamma 0, or gamma 180 if the plane's peak is above the horizon. The outermost
/// directions are sought within 90 degrees of the axis, so a batwing's dip does not count and a
/// faint second lobe to the other side does not either; light that goes on past the horizon is
/// followed until it falls below the threshold. A light to one side of the axis only has its own
/// lobe's width. 0 if the reference is 0. Exact for the piecewise linear table.
double beamAngleDeg(const IntensityDistribution& distribution, double c_deg, double share,
                    BeamReference reference);

/// Both principal planes.
struct PrincipalAngles {
  double c0_deg = 0.0;   ///< in the plane C0-C180
  double c90_deg = 0.0;  ///< in the plane C90-C270
};

/// Full angle between the directions of half the reference intensity.
PrincipalAngles beamAngles(const IntensityDistribution& distribution, BeamReference reference);
/// Full angle between the directions of a tenth of the reference intensity.
PrincipalAngles fieldAngles(const IntensityDistribution& distribution, BeamReference reference);

}  // namespace soffit::photometry
