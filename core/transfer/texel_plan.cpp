// SPDX-License-Identifier: MIT
#include "core/transfer/texel_plan.h"

#include <algorithm>

namespace soffit::transfer {

TexelPlan planTexels(const StaticScene& scene, const BakeSettings& settings) {
  TexelPlan plan;
  plan.count = static_cast<std::size_t>(settings.texels);
  plan.least_cell = std::min(settings.least_cell, scene.mesh->bounds().diagonal() / 200.0);
  const auto cellForWhole = [&] {
    const double whole = settings.whole_cells * static_cast<double>(plan.count);
    return cellForCount(*scene.mesh, scene.sides, static_cast<std::size_t>(whole), plan.least_cell);
  };
  plan.cell = cellForWhole();
  const double most = std::max(settings.most_cell, plan.least_cell);
  if (plan.cell <= most) return plan;
  // As many as such cells take. Not by the ratio of areas: thousands of small faces, each with a
  // texel of its own, make cells for the rest that are far larger than they need be.
  const std::size_t cells = makeTexels(*scene.mesh, scene.sides, most, nullptr).texelCount();
  const auto wanted = static_cast<std::size_t>(static_cast<double>(cells) / settings.whole_cells);
  plan.count = std::clamp(wanted, plan.count, 4 * plan.count);
  plan.cell = std::max(most, cellForWhole());
  return plan;
}

}  // namespace soffit::transfer
