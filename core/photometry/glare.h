// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/photometry/quantities.h"

#include <span>

/// Discomfort glare: the Unified Glare Rating of CIE 117 and Guth's position index.
namespace soffit::photometry {

/// One luminous part as an eye sees it.
struct GlareSource {
  Luminance luminance;          ///< toward the eye
  SolidAngle solid_angle;       ///< seen from the eye
  double position_index = 1.0;  ///< Guth's p ≥ 1; infinite where the source is out of sight
};

/// UGR = 8 log10((0.25 / L_b) Σ L² ω / p²), L_b = E_indirect,eye / π.
///
/// indirect_at_eye  vertical illuminance at the eye without the sources' direct light, > 0.
/// return           10 is hardly noticed, 28 is unbearable; -infinity without any source in sight.
double ugr(std::span<const GlareSource> sources, Illuminance indirect_at_eye);

/// Guth's index for a source above the line of sight (IES Lighting Handbook):
///   p = exp((35.2 - 0.31889 τ - 1.22 e^(-2τ/9)) 10⁻³ σ + (21 + 0.26667 τ - 0.002963 τ²) 10⁻⁵ σ²)
///
/// tau    radians between the vertical and the plane of source and line of sight, 0..π/2.
/// sigma  radians between the line of sight and the source; infinite from π/2 on.
double guthPositionIndex(double tau, double sigma);

/// Position index for a source anywhere. Below the line of sight Guth says nothing; there it is
/// p = 1 + 0.8 R/D for R < 0.6 D, else 1 + 1.2 R/D (Iwata & Tokura 1997), with R the distance
/// from the line of sight in the plane of the source and D the distance along it.
///
/// view, up, to_source  unit vectors of one frame; up need not be perpendicular to view, but not
///                      parallel to it.
double positionIndex(const dvec3& view, const dvec3& up, const dvec3& to_source);

}  // namespace soffit::photometry
