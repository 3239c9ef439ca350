// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/half.h"

#include <cstddef>
#include <vector>

namespace soffit::glossy {

/// Receivers lie in blocks of 16 side by side, so that one vector instruction serves them whatever
/// its width.
inline constexpr std::size_t kBlock = 16;

/// `rows` numbers of each of many receivers: row i of receiver r is at [(r / 16) rows + i][r % 16].
/// The last block is filled up with zeros.
template <class T>
class ReceiverBlocks {
 public:
  ReceiverBlocks() = default;
  ReceiverBlocks(std::size_t receivers, std::size_t rows)
      : receivers_(receivers), rows_(rows), values_(blocks() * rows * kBlock, T(0.0F)) {}

  [[nodiscard]] std::size_t receivers() const { return receivers_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t blocks() const { return (receivers_ + kBlock - 1) / kBlock; }
  [[nodiscard]] std::size_t bytes() const { return values_.size() * sizeof(T); }

  [[nodiscard]] T& at(std::size_t receiver, std::size_t row) {
    return values_[(receiver / kBlock * rows_ + row) * kBlock + receiver % kBlock];
  }
  [[nodiscard]] T at(std::size_t receiver, std::size_t row) const {
    return values_[(receiver / kBlock * rows_ + row) * kBlock + receiver % kBlock];
  }
  [[nodiscard]] const T* block(std::size_t b) const { return values_.data() + b * rows_ * kBlock; }
  [[nodiscard]] T* block(std::size_t b) { return values_.data() + b * rows_ * kBlock; }

 private:
  std::size_t receivers_ = 0;
  std::size_t rows_ = 0;
  std::vector<T> values_;
};

using FloatBlocks = ReceiverBlocks<float>;
using HalfBlocks = ReceiverBlocks<transfer::Half>;

}  // namespace soffit::glossy
