// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/light/cull_kernel.h"
#include "core/light/shaft.h"

namespace soffit::light {

/// Boxes in a hierarchy of 16 children per node, asked with shafts, 16 boxes per test. Immutable.
class BoxTree {
 public:
  BoxTree() = default;
  /// The boxes' order is kept: neighbours in it should be neighbours in space (orderByPlace).
  explicit BoxTree(std::span<const Box> boxes);

  /// 16 boxes in a row, of which those with a set bit matter.
  struct Part {
    std::uint32_t block = 0;
    std::uint32_t bits = 0;
    [[nodiscard]] std::size_t index(int bit) const {
      return block * BoxBlock::kSize + static_cast<std::size_t>(bit);
    }
  };
  /// Appends what is not certainly outside the shaft.
  void collect(const Shaft& shaft, std::vector<Part>& out) const;
  /// What is left of a part in a narrower shaft.
  [[nodiscard]] std::uint32_t refine(const Part& part, const Shaft& shaft) const {
    return part.bits & cullBoxes(levels_[0][part.block], shaft.planes());
  }

 private:
  void visit(std::size_t level, std::size_t block, const Shaft& shaft,
             std::vector<Part>& out) const;

  std::vector<std::vector<BoxBlock>> levels_;  ///< 0: of items; k + 1: of the blocks of level k
};

/// A permutation by a k-d tree whose cuts lie at multiples of powers of 16: every run of 16, of
/// 256 and so on from the start is a compact set. Deterministic.
std::vector<std::uint32_t> orderByPlace(std::span<const vec3> points);

}  // namespace soffit::light
