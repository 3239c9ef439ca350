// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/json.h"
#include "core/math/vec.h"

#include <string>
#include <vector>

/// Probes as the project keeps them: points of surfaces whose light is watched.
namespace soffit::io {

class Report;

struct Probe {
  std::string name;
  dvec3 position{0.0};          ///< world, on a surface
  dvec3 normal{0.0, 0.0, 1.0};  ///< unit, out of the side that is read

  friend bool operator==(const Probe&, const Probe&) = default;
};

/// The member "probes" of the project (internal to io_project):
/// [ { "name": "Desk by the window", "position": [1, 2, 0.75], "normal": [0, 0, 1] } ].
/// A normal of any length but 0 will do.
std::vector<Probe> readProbes(const Json& value, const std::string& path, Report& report);
/// A document's; none where it has faults.
std::vector<Probe> probesOf(const Json& root);
/// Brings a document up to date, touching nothing when they are the same.
void syncProbes(const std::vector<Probe>& probes, Json& root);

}  // namespace soffit::io
