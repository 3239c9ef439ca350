// SPDX-License-Identifier: MIT
#include "core/light/blocker_lanes.h"

#include <algorithm>

namespace soffit::light {

void putBlocker(const MaskBlocker& b, float* column, std::size_t stride) {
  const auto put = [&](std::size_t row, float value) { column[row * stride] = value; };
  for (std::size_t c = 0; c < BlockerRow::kCorners; ++c) {
    const vec3& corner = b.corners[c < static_cast<std::size_t>(b.count) ? c : 0];
    put(BlockerRow::kX + c, corner.x);
    put(BlockerRow::kY + c, corner.y);
    put(BlockerRow::kZ + c, corner.z);
  }
  put(BlockerRow::kNx, b.normal.x);
  put(BlockerRow::kNy, b.normal.y);
  put(BlockerRow::kNz, b.normal.z);
  put(BlockerRow::kD, b.d);
  put(BlockerRow::kCount, static_cast<float>(b.count));
  put(BlockerRow::kSolid, b.solid ? 1.0F : 0.0F);
  vec3 twice(0.0F);
  for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(b.count); ++k) {
    twice += glm::cross(b.corners[k] - b.corners[0], b.corners[k + 1] - b.corners[0]);
  }
  put(BlockerRow::kArea, 0.5F * glm::length(twice));
}

MaskBlocker blockerAt(const float* column, std::size_t stride) {
  const auto get = [&](std::size_t row) { return column[row * stride]; };
  MaskBlocker b;
  b.count = static_cast<int>(get(BlockerRow::kCount));
  for (std::size_t c = 0; c < BlockerRow::kCorners; ++c) {
    b.corners[c] = {get(BlockerRow::kX + c), get(BlockerRow::kY + c), get(BlockerRow::kZ + c)};
  }
  b.normal = {get(BlockerRow::kNx), get(BlockerRow::kNy), get(BlockerRow::kNz)};
  b.d = get(BlockerRow::kD);
  b.solid = get(BlockerRow::kSolid) > 0.0F;
  return b;
}

void BlockerLanes::clear() {
  size_ = 0;
  five_ = false;
}

void BlockerLanes::reserve(std::size_t more) {
  const std::size_t needed = size_ + more + kBlock;
  if (needed <= stride_) return;
  // An odd number of cache lines: rows do not compete for the same places of the cache.
  const std::size_t lines = std::max(needed, 2 * stride_) / kBlock + 1;
  const std::size_t stride = (lines | 1U) * kBlock;
  std::vector<float> data(stride * BlockerRow::kRows, 0.0F);
  for (std::size_t r = 0; r < BlockerRow::kRows; ++r) {
    std::copy_n(data_.begin() + static_cast<std::ptrdiff_t>(r * stride_), size_,
                data.begin() + static_cast<std::ptrdiff_t>(r * stride));
  }
  data_ = std::move(data);
  stride_ = stride;
}

void BlockerLanes::push(const MaskBlocker& blocker) {
  reserve(1);
  putBlocker(blocker, data_.data() + size_, stride_);
  five_ = five_ || blocker.count > 4;
  ++size_;
}

void BlockerLanes::swap(std::size_t i, std::size_t k) {
  for (std::size_t r = 0; r < BlockerRow::kRows; ++r) std::swap(row(r)[i], row(r)[k]);
}

MaskBlocker BlockerLanes::at(std::size_t i) const {
  return blockerAt(data_.data() + i, stride_);
}

}  // namespace soffit::light
