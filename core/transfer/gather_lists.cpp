// SPDX-License-Identifier: MIT
#include "core/transfer/gather_lists.h"

#include "core/transfer/texels.h"

#include <algorithm>

namespace soffit::transfer {

void GatherLists::append(std::span<std::uint32_t> slots, const SlotClusters& clusters) {
  std::sort(slots.begin(), slots.end());
  List list;
  list.first_block = static_cast<std::uint32_t>(blocks.size());
  list.scale = slots.empty() ? 0.0F : 1.0F / static_cast<float>(slots.size());
  std::uint32_t cluster = kNoTexel;
  std::uint32_t base = 0;
  for (std::size_t i = 0; i < slots.size() && slots[i] != kNoTexel;) {
    std::size_t j = i;
    while (j < slots.size() && slots[j] == slots[i] && j - i < 255) ++j;
    const std::uint32_t slot = slots[i];
    if (clusters.cluster_of[slot] != cluster) {
      cluster = clusters.cluster_of[slot];
      base = clusters.begin[cluster];
      blocks.push_back({cluster, base, static_cast<std::uint32_t>(entries.size()), 0});
    }
    entries.push_back({static_cast<std::uint8_t>(slot - base), static_cast<std::uint8_t>(j - i)});
    ++blocks.back().count;
    i = j;
  }
  list.block_count = static_cast<std::uint32_t>(blocks.size()) - list.first_block;
  lists.push_back(list);
}

void GatherLists::append(const GatherLists& other) {
  const auto entry_shift = static_cast<std::uint32_t>(entries.size());
  const auto block_shift = static_cast<std::uint32_t>(blocks.size());
  entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  for (Block b : other.blocks) {
    b.first += entry_shift;
    blocks.push_back(b);
  }
  for (List l : other.lists) {
    l.first_block += block_shift;
    lists.push_back(l);
  }
}

SlotClusters slotClusters(const light::Receivers& receivers) {
  SlotClusters out;
  out.cluster_of.resize(receivers.slotCount());
  for (std::uint32_t c = 0; c < receivers.clusters.size(); ++c) {
    const light::Receivers::Cluster& cluster = receivers.clusters[c];
    out.begin.push_back(cluster.begin);
    std::fill(out.cluster_of.begin() + cluster.begin, out.cluster_of.begin() + cluster.end, c);
  }
  return out;
}

}  // namespace soffit::transfer
