// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

#include <cstddef>

namespace soffit::transfer {

/// How many texels a scene gets, and in what cells.
struct TexelPlan {
  std::size_t count = 0;  ///< texels, splits of cells included
  double least_cell = 0;  ///< m
  double cell = 0;        ///< m: base cells
};

/// Whole cells first, the rest for cells that are worth splitting (BakeSettings::whole_cells).
/// Where cells of most_cell would not do, up to four times as many texels as wished.
TexelPlan planTexels(const StaticScene& scene, const BakeSettings& settings);

}  // namespace soffit::transfer
