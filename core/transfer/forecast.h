// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

#include <cstddef>

namespace soffit::transfer {

/// What a bake is likely to take.
struct BakeForecast {
  std::size_t texels = 0;
  double bytes = 0.0;    ///< of the operators, in memory and in the cache
  double seconds = 0.0;  ///< on `threads` cores that are free
};

/// Known before the bake: texels are counted, rays of which some are timed here (some 50 ms; once
/// more the time that an empty box takes: how fast the machine is). Memory and time per texel and
/// ray are fitted to the bakes of the four sample projects at all three qualities, which they meet
/// within a quarter (README.md, Forecast); settings far from those may differ more.
/// threads >= 1.
BakeForecast forecastBake(const StaticScene& scene, const BakeSettings& settings, int threads);

}  // namespace soffit::transfer
