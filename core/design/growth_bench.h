// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// How the engine's times grow with the size of a building and with the number of luminaires.
namespace soffit::design {

/// One generated room (growth_room.h).
struct GrowthRow {
  std::string task;  ///< "triangles" or "luminaires": what grows
  std::size_t triangles = 0;
  std::size_t luminaires = 0;
  std::size_t texels = 0;
  double bake_s = 0.0;
  double first_s = 0.0;    ///< until the first usable result
  double megabytes = 0.0;  ///< operators
  double all_ms = 0.0;     ///< light of all luminaires, from none
  double move_ms = 0.0;    ///< one luminaire moved, the others shine on: median
  double mix_ms = 0.0;     ///< all of them dimmed
};

/// time ~ size^exponent, by least squares over the logarithms.
struct GrowthExponent {
  std::string task;
  std::string figure;  ///< "bake_s", ..
  double exponent = 0.0;
};

struct GrowthOptions {
  std::size_t most_triangles = 1000000;  ///< 1,000 and tenfold steps up to it
  std::size_t most_luminaires = 1000;    ///< 1 and tenfold steps
  std::string quality = "interactive";
  int moves = 20;  ///< per room
  std::uint64_t seed = 1;
};

/// Measures on the threads that are allowed; bakes are not cached. Errors: the engine's; cancelled.
Result<std::vector<GrowthRow>> measureGrowth(const GrowthOptions& options, const Job& job);

/// Of each figure that rooms of one task have, where at least two have it.
std::vector<GrowthExponent> growthExponents(const std::vector<GrowthRow>& rows);

/// task,triangles,luminaires,texels,bake_s,first_s,megabytes,all_ms,move_ms,mix_ms; a header and a
/// row per element.
std::string formatGrowthRows(const std::vector<GrowthRow>& rows);

}  // namespace soffit::design
