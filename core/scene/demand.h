// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace soffit::scene {

/// What a project needs to be computed, and what it does not and why.
struct Demand {
  struct Skip {
    std::string what;
    std::string why;
  };
  std::vector<std::string> needed;
  std::vector<Skip> skipped;
};

/// For the scene's own luminaires, as they are switched.
Demand demandOf(const Scene& scene);

}  // namespace soffit::scene
