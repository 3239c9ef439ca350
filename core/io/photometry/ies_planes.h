// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/photometry/intensity_distribution.h"

#include <string>
#include <vector>

namespace soffit::io {

/// Photometric type of LM-63: 1 C, 2 B, 3 A.
enum class IesType { c = 1, b = 2, a = 3 };

/// The table of an LM-63 file, factors applied.
struct IesTable {
  IesType type = IesType::c;
  std::vector<double> vertical_deg;
  std::vector<double> horizontal_deg;
  std::vector<double> candela;  ///< row-major [horizontal][vertical]
};

/// The table on the whole sphere.
struct IesSphere {
  photometry::IntensityDistribution distribution;
  double lumens = 0.0;   ///< of the stored table
  std::string symmetry;  ///< "axial", "quadrant 0-90", "type B 0-90 (H mirrored)", ...
  std::vector<std::string> warnings;
};

/// Do these ascending angles cover what LM-63 allows? Type C: vertical within 0..180, horizontal
/// {one}, 0-90, 0-180, 90-270, 0-360 (also without its closing plane, or as -180-180); types A
/// and B: a longitude within -180..180, a latitude within -90..90. Errors have no place: the
/// caller knows the line.
Result<void> checkIesAngles(IesType type, const std::vector<double>& vertical_deg,
                            const std::vector<double>& horizontal_deg);

/// Unfolds what the horizontal angles leave to mirrors (types A and B are mirrored where they
/// start at 0). The angles have passed checkIesAngles().
IesSphere toSphere(IesTable table);

}  // namespace soffit::io
