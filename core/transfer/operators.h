// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/transfer/gather_lists.h"
#include "core/transfer/half.h"
#include "core/transfer/node_lists.h"
#include "core/transfer/nodes.h"
#include "core/transfer/static_scene.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// What geometry alone decides about the bounce: the product of the bake.
namespace soffit::transfer {

struct BakeSettings {
  int texels = 52000;  ///< wished number of source texels
  double whole_cells =
      0.6;  ///< of these, the share that even cells would take: the others come from splitting
  double least_cell =
      0.03;  ///< m, no smaller base cells than this, or 1/200 of the scene where that is less
  double most_cell = 1e3;     ///< m: where cells would be larger, up to four times as many texels
  std::uint32_t patch = 128;  ///< texels per node patch
  int node_rays = 8;          ///< squared: rays per texel for the node matrix
  int trainings = 160;        ///< training lights
  int field_rays = 24;        ///< squared: rays per texel for the training fields
  int list_rays = 32;         ///< squared: rays per skeleton point
  int max_rank = 64;          ///< skeleton points per cluster at most
  double lists = 0.3;        ///< skeleton points per texel at most, where they tell most
  double tolerance =
      0.03;  ///< a skeleton point that tells less than this share of the mean is left out
  std::uint64_t seed = 1;
};

/// How the cluster's indirect light follows from its skeleton points.
struct ClusterWeights {
  std::uint32_t first_list = 0;
  std::uint32_t rank = 0;
  std::size_t first_weight = 0;  ///< rank x slots, row-major
};

struct Operators {
  Texels texels;
  std::vector<float>
      area;  ///< per slot: what takes part in the bounce; 0 for padding and invalid texels
  std::vector<std::uint32_t>
      fill_from;  ///< per slot: itself, or the valid slot whose light it shows
  /// Per slot: 1 where most of what it sees is the inside of solids, and no valid texel is near to
  /// show the light of. Light does not get there, and a ray that slips in at a seam finds it dark.
  std::vector<std::uint8_t> buried;
  /// Per slot, m^2: what one lux of radiosity makes in lux times m^2 elsewhere: the area, less what
  /// leaves the scene; of texels that take no part, what the lists see of them.
  std::vector<float> sends;
  Nodes nodes;
  GatherLists lists;     ///< what each skeleton point sees, by texels and by FarBlocks of them
  NodeLists node_lists;  ///< the same by node functions
  std::vector<ClusterWeights> clusters;  ///< per cluster of texels.receivers
  std::vector<Half> weights;  ///< sums of some 20 of them: rounding disappears in the rays' noise
  std::vector<float>
      list_area;  ///< per list: sum over slots of area x weight, for energy conservation
  /// How far the balance of what is sent and what arrives is to be trusted, 0 to 1. It holds to
  /// rounding in a room without clutter. Where furniture makes the sum over areas err (a texel's
  /// light is that at its point) as much as lists and weights do, these err there and nowhere else,
  /// and a balance that is forced takes light from the open walls for it: 1.0 % of all reflected
  /// light on the office's work planes, 0.4 % without it. (g^4 - q^4) / (g^4 + q^4) for usual
  /// errors g of lists and weights, q of the areas, both measured on the training lights; 0 where q
  /// > g.
  float conserve = 1.0F;
  bool coarse = false;  ///< lists and weights are not there yet: indirect from nodes alone

  [[nodiscard]] std::size_t bytes() const;
};

struct BakeCounts {
  double seconds = 0.0;
  double first_result_seconds = 0.0;  ///< until the first coarse result, or the only one
  double coarse_seconds = 0.0;        ///< until that with all texels
  std::uint64_t rays = 0;
  double texel_seconds = 0, node_seconds = 0, training_seconds = 0, field_seconds = 0,
         list_seconds = 0;
};

/// Called with coarse operators as soon as they are there: where many texels are wished first with
/// few, then with all.
using CoarseResult = std::function<void(std::shared_ptr<const Operators>)>;

/// Bakes. Errors: cancelled. Deterministic for equal settings, whatever the thread count.
Result<std::shared_ptr<const Operators>> bake(const StaticScene& scene,
                                              const BakeSettings& settings, const Job& job,
                                              const CoarseResult& coarse,
                                              BakeCounts* counts = nullptr);

}  // namespace soffit::transfer
