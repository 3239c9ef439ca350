// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/intensity_distribution.h"

#include <string_view>

namespace soffit::photometry {

/// What a turn or a mirror leaves as it is; from most to least.
enum class Symmetry {
  axial,      ///< the same in every C-plane
  quadrant,   ///< mirrored about C0-C180 and about C90-C270
  about_c0,   ///< mirrored about C0-C180: I(C) = I(-C)
  about_c90,  ///< mirrored about C90-C270: I(C) = I(180 - C)
  none,
};

/// The symmetry that the intensities have, whatever the file claims.
///
/// tolerance  greatest difference that still counts as equal, as a share of the peak; the default
///            forgives only rounding.
Symmetry detectSymmetry(const IntensityDistribution& distribution, double tolerance = 1e-9);

/// One or a few words for people: "axial", "quadrant", "bilateral about C0-C180", ...
std::string_view symmetryName(Symmetry symmetry);

}  // namespace soffit::photometry
