// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/receivers.h"
#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Which cluster a slot belongs to, and where clusters begin.
struct SlotClusters {
  std::vector<std::uint32_t> cluster_of;  ///< per slot
  std::vector<std::uint32_t> begin;       ///< per cluster
};
SlotClusters slotClusters(const light::Receivers& receivers);

/// Gather rays as sparse sums over texels: value = scale * sum count_k x[slot_k], the irradiance
/// that radiosity x (lux) sends to the point. Two bytes an entry: a texel's place within
/// its cluster of at most 256 slots, and how many of the rays ended there.
struct GatherLists {
  struct Entry {
    std::uint8_t local = 0;
    std::uint8_t count = 0;
  };
  struct Block {
    std::uint32_t cluster = 0;
    std::uint32_t base = 0;   ///< first slot of the cluster
    std::uint32_t first = 0;  ///< into entries
    std::uint32_t count = 0;
  };
  struct List {
    std::uint32_t first_block = 0;
    std::uint32_t block_count = 0;
    float scale = 0.0F;  ///< 1 / number of rays
  };
  std::vector<Entry> entries;
  std::vector<Block> blocks;
  std::vector<List> lists;

  /// Appends the list of a point: `slots` as traceHemisphere gives them (kNoTexel: dark), sorted
  /// in place; clusters: which cluster each slot belongs to.
  void append(std::span<std::uint32_t> slots, const SlotClusters& clusters);
  /// Appends all lists of another set.
  void append(const GatherLists& other);
  [[nodiscard]] std::size_t bytes() const {
    return entries.size() * sizeof(Entry) + blocks.size() * sizeof(Block) + lists.size() * sizeof(List);
  }
};

}  // namespace soffit::transfer
