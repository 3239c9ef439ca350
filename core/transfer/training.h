// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/transfer/far_blocks.h"
#include "core/transfer/nodes.h"
#include "core/transfer/operators.h"
#include "core/transfer/static_scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Radiosity fields that lights in this scene excite: value[slot * count + t], lux of reflected
/// light for training light t, scaled to an area mean of 1; the means of `blocks` follow the slots.
/// The last is even light, 3 everywhere. Positions, sizes, kinds and the materials' reflectances
/// are drawn at random (fixed seed): never the project's own.
struct TrainingFields {
  int count = 0;
  std::vector<float> value;
  FarBlocks blocks;
};

/// hits: node_rays^2 texel slots per slot (hemisphere.h), for one bounce at texel resolution.
TrainingFields makeTrainingFields(const StaticScene& scene, const Operators& operators,
                                  std::span<const std::uint32_t> hits, int rays, const BakeSettings& settings,
                                  const Job& job);

}  // namespace soffit::transfer
