// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Texels seen from afar: the mean of 4 or of 16 neighbours stands for each of them where a point
/// has few rays for so many. Sending takes one mean for what would be several texels, and it is the
/// better answer: the mean of all texels that a ray stands for instead of one drawn among them.
/// (Prefiltering by the footprint of a ray: Igehy 1999; Krivanek, Colbert 2008.)
///
/// Blocks are aligned runs of 4 and 16 slots, which light::makeReceivers lays close together. Their
/// means follow the slots: block k of 4 at slots + k, block k of 16 at slots + slots/4 + k.
class FarBlocks {
 public:
  FarBlocks() = default;
  /// area: per slot, what takes part in the bounce.
  FarBlocks(const Texels& texels, std::span<const float> area);

  /// Slots and blocks together: how many values a field with its means has.
  [[nodiscard]] std::size_t size() const { return slots_ + slots_ / 4 + slots_ / 16; }
  [[nodiscard]] static std::size_t sizeFor(std::size_t slots) {
    return slots + slots / 4 + slots / 16;
  }
  [[nodiscard]] std::size_t slotCount() const { return slots_; }

  /// Replaces the ends of cosine-distributed rays from p (unit normal n), each of which carries the
  /// `share` 1/N of all, by the largest blocks around them that sixteen rays or fewer stand for.
  void stepBack(const Texels& texels, const vec3& p, const vec3& n, float share,
                std::span<std::uint32_t> ends) const;

  /// Writes the means of the blocks of the slots [begin, end), multiples of 16, of a field with
  /// `channels` values per slot.
  void average(std::size_t begin, std::size_t end, std::size_t channels,
               std::span<float> field) const;
  /// The same for RGB + padding.
  void average(std::size_t begin, std::size_t end, std::span<vec4> field) const;

  /// The index of the block of 4 or 16 (level 1 or 2) that holds a slot.
  [[nodiscard]] std::size_t index(int level, std::size_t slot) const {
    return level == 1 ? slots_ + slot / 4 : slots_ + slots_ / 4 + slot / 16;
  }

 private:
  /// What a block looks like from afar.
  struct Extent {
    float area = 0.0F;       ///< m^2
    float diagonal = 1e30F;  ///< m; huge where the mean may not stand for its texels
  };

  [[nodiscard]] Extent extentOf(const Texels& texels, std::span<const float> area,
                                std::size_t begin, std::size_t count) const;

  std::size_t slots_ = 0;
  std::vector<float> of_four_;     ///< per slot: its share of its block of 4
  std::vector<float> of_sixteen_;  ///< per block of 4: its share of its block of 16
  std::vector<Extent> extents_;    ///< per block, as they follow the slots
};

}  // namespace soffit::transfer
