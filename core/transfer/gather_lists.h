// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Gather rays as sparse sums over texels: value = scale * sum count_k x[slot_k], the irradiance
/// over pi... of radiosity x (lux) that the point sees. Two bytes an entry: a texel's place within
/// its cluster of at most 256 slots, and how many of the rays ended there.
struct GatherLists {
  struct Entry {
    std::uint8_t local = 0;
    std::uint8_t count = 0;
  };
  struct Block {
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
  /// in place; cluster_base: per slot, the first slot of its cluster.
  void append(std::span<std::uint32_t> slots, std::span<const std::uint32_t> cluster_base);
  /// Appends all lists of another set.
  void append(const GatherLists& other);
  [[nodiscard]] std::size_t bytes() const {
    return entries.size() * sizeof(Entry) + blocks.size() * sizeof(Block) + lists.size() * sizeof(List);
  }
};

/// First slot of each slot's cluster.
std::vector<std::uint32_t> clusterBases(std::span<const std::uint32_t> cluster_begin,
                                        std::span<const std::uint32_t> cluster_end, std::size_t slots);

}  // namespace soffit::transfer
