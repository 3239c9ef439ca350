// SPDX-License-Identifier: MIT
#include "core/transfer/gather_lists.h"

#include "core/transfer/texels.h"

#include <algorithm>

namespace soffit::transfer {

void GatherLists::append(std::span<std::uint32_t> slots, std::span<const std::uint32_t> cluster_base) {
  std::sort(slots.begin(), slots.end());
  List list;
  list.first_block = static_cast<std::uint32_t>(blocks.size());
  list.scale = slots.empty() ? 0.0F : 1.0F / static_cast<float>(slots.size());
  std::uint32_t base = kNoTexel;
  for (std::size_t i = 0; i < slots.size() && slots[i] != kNoTexel;) {
    std::size_t j = i;
    while (j < slots.size() && slots[j] == slots[i] && j - i < 255) ++j;
    const std::uint32_t slot = slots[i];
    if (cluster_base[slot] != base) {
      base = cluster_base[slot];
      blocks.push_back({base, static_cast<std::uint32_t>(entries.size()), 0});
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

std::vector<std::uint32_t> clusterBases(std::span<const std::uint32_t> cluster_begin,
                                        std::span<const std::uint32_t> cluster_end, std::size_t slots) {
  std::vector<std::uint32_t> base(slots, 0);
  for (std::size_t c = 0; c < cluster_begin.size(); ++c) {
    std::fill(base.begin() + cluster_begin[c], base.begin() + cluster_end[c], cluster_begin[c]);
  }
  return base;
}

}  // namespace soffit::transfer
