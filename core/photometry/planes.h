// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/intensity_distribution.h"

#include <utility>
#include <vector>

/// From the C-planes that a file stores to the whole circle that a distribution holds.
namespace soffit::photometry {

/// Which mirror planes a file leaves to the reader.
enum class Mirror {
  none,  ///< the stored planes go all round, with or without the closing one at 360
  c0,    ///< about the plane C0-C180: 0..180 is stored
  c90,   ///< about the plane C90-C270: 90..270, or 270..450, is stored
  both,  ///< about both: 0..90 is stored
};

/// A table as stored. c_deg: strictly ascending, any range of at most 360; gamma_deg: strictly
/// ascending in 0..180; candela: row-major [c][gamma].
struct StoredPlanes {
  std::vector<double> c_deg;
  std::vector<double> gamma_deg;
  std::vector<double> candela;
};

/// Unfolds mirrored planes, brings the angles to 0..360 and closes the circle, without changing
/// the lumens: a plane given at both 0 and 360 becomes their mean weighted by the neighbouring
/// gaps, and a circle without C0 gets one by interpolation. One plane means axial symmetry.
IntensityDistribution unfold(const StoredPlanes& stored, Mirror mirror);

/// The fewest planes, and their mirror, that unfold() turns into the same distribution again, to
/// the bit. Without symmetry they are all planes, not closed at 360.
std::pair<StoredPlanes, Mirror> fold(const IntensityDistribution& distribution);

}  // namespace soffit::photometry
