// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/spaces.h"
#include "core/io/project/json.h"
#include "core/io/project/project.h"
#include "core/scene/demand.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soffit::cli {

/// What the bake is likely to take, from quality and area.
struct Cost {
  std::size_t receivers = 0;  ///< display points that light is computed at
  double bake_s = 0.0;        ///< on this machine's cores; nothing when it is cached
  double megabytes = 0.0;     ///< operators in memory and in the cache
};

struct InfoReport {
  scene::Demand demand;
  Cost cost;
  std::vector<geometry::Space> rooms;  ///< relative to Mesh::origin
  std::vector<double> areas;           ///< m² per material
  std::vector<std::string> warnings;
};

/// Readable, a line per thing, so that somebody finds the way around a building of others.
std::string toText(const io::Project& project, const InfoReport& report);

io::Json toJson(const io::Project& project, const InfoReport& report);

}  // namespace soffit::cli
