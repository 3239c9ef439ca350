// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/gather_lists.h"
#include "core/transfer/nodes.h"

#include <cstdint>
#include <vector>

namespace soffit::transfer {

/// The gather lists again, seen through the node basis: value = scale * sum over patches of
/// (count b_0 + sum phi_1 b_1 + sum phi_2 b_2) over the rays that end in the patch. Smooth light
/// (all that has bounced) costs a fifth of the taps this way; direct light keeps its texels.
///
/// Where a patch is seen whole the sums of phi tend to 0, and what few rays give instead is noise
/// (phi has unit variance over the patch): sums that chance explains are left out.
struct NodeLists {
  GatherLists constants;  ///< count b_0; its slots are patches
  /// Sums of phi are stored in steps of kStep: half a ray, far below the rays' own noise.
  static constexpr float kStep = 0.5F;
  /// Larger sums and gaps than it holds take several entries.
  struct Entry {
    std::uint16_t gap = 0;  ///< patches since the entry before; of a list's first one its patch
    std::int8_t phi1 = 0;
    std::int8_t phi2 = 0;
  };
  struct List {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    float scale = 0.0F;
  };
  std::vector<Entry> entries;
  std::vector<List> lists;

  [[nodiscard]] std::size_t bytes() const {
    return constants.bytes() + entries.size() * sizeof(Entry) + lists.size() * sizeof(List);
  }
};

NodeLists makeNodeLists(const GatherLists& lists, const Nodes& nodes);

}  // namespace soffit::transfer
