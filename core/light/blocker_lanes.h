// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/light/light_mask.h"

namespace soffit::light {

/// The numbers of a blocker, each a row of a table whose columns are blockers. Corners that a
/// blocker does not have repeat its first: the successor of the last corner is always the next
/// row, and least heights over all rows need no count.
struct BlockerRow {
  static constexpr std::size_t kCorners = 5;
  static constexpr std::size_t kX = 0;
  static constexpr std::size_t kY = kX + kCorners;
  static constexpr std::size_t kZ = kY + kCorners;
  static constexpr std::size_t kNx = kZ + kCorners;
  static constexpr std::size_t kNy = kNx + 1;
  static constexpr std::size_t kNz = kNy + 1;
  static constexpr std::size_t kD = kNz + 1;         ///< of the plane n.x = d
  static constexpr std::size_t kCount = kD + 1;      ///< corners, 3 to 5
  static constexpr std::size_t kSolid = kCount + 1;  ///< 1: hides only what lies behind its front
  static constexpr std::size_t kArea = kSolid + 1;   ///< m^2, for what should come first
  static constexpr std::size_t kRows = kArea + 1;
};

/// Blockers side by side for kernels that take 16 at a time: a growing table, row by row. Reused
/// from group to group: clear() keeps the memory.
class BlockerLanes {
 public:
  static constexpr std::size_t kBlock = 16;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// Whether any blocker may have five corners; others need only the first four corner rows.
  [[nodiscard]] bool five() const { return five_; }
  void clear();
  void push(const MaskBlocker& blocker);
  [[nodiscard]] MaskBlocker at(std::size_t i) const;

  /// Row r, BlockerRow's numbers; size() values and memory for kBlock more.
  [[nodiscard]] const float* row(std::size_t r) const { return data_.data() + r * stride_; }
  /// The same for those that append: after writing at size(), call grow().
  [[nodiscard]] float* row(std::size_t r) { return data_.data() + r * stride_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// Makes room for `more` blockers and kBlock beyond.
  void reserve(std::size_t more);
  void swap(std::size_t i, std::size_t k);
  void grow(std::size_t more) { size_ += more; }
  void markFive() { five_ = true; }

 private:
  std::vector<float> data_;
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
  bool five_ = false;
};

/// Writes one blocker to a column of a table with this distance between rows.
void putBlocker(const MaskBlocker& blocker, float* column, std::size_t stride);
/// Reads it again.
MaskBlocker blockerAt(const float* column, std::size_t stride);

}  // namespace soffit::light
