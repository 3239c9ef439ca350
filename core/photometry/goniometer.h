// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/intensity_distribution.h"

#include <vector>

/// Goniometer types A and B (automotive lamps and floodlights) brought to C-gamma.
///
/// Both have their centre (V = 0, H = 0) on gamma 0. As in CIE 121 and EN 13032-1, +V leans to C0
/// and +H to C90; the two types differ in which of the angles is the latitude of the sphere:
///   type A  polar axis along C0-C180, V is the latitude: dω = cos V dV dH
///           (C0, C90, down) = (sin V, cos V sin H, cos V cos H)
///   type B  polar axis along C90-C270, H is the latitude: dω = cos H dV dH
///           (C0, C90, down) = (cos H sin V, sin H, cos H cos V)
namespace soffit::photometry {

enum class GonioType { a, b };

/// A table of type A or B; outside its angles the intensity is 0.
struct GonioTable {
  GonioType type = GonioType::b;
  std::vector<double> vertical_deg;  ///< strictly ascending, at least 2; |V| ≤ 90 for A, 180 for B
  std::vector<double> horizontal_deg;  ///< strictly ascending; |H| ≤ 180 for A, 90 for B
  std::vector<double> candela;         ///< row-major [horizontal][vertical]
  bool mirrored = false;               ///< H starts at 0 and the other half is its mirror image
};

/// cd toward `direction` (unit, luminaire frame): bilinear in V and H.
double gonioIntensity(const GonioTable& table, const dvec3& direction);

/// Lumens: linear in the latitude with the exact cosine, trapezoid in the other angle.
double gonioFlux(const GonioTable& table);

/// Resamples to C-gamma at half the finest step of the table (gamma 0.05..1, C 1..2.5 degrees)
/// and scales the result so that its flux() is gonioFlux(): the resampling alone errs by some
/// 1e-4 of the lumens, and near the C90 pole of type B cells are narrower than C planes are apart.
IntensityDistribution toCGamma(const GonioTable& table);

}  // namespace soffit::photometry
