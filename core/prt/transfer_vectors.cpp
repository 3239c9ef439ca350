// SPDX-License-Identifier: MIT
#include "core/prt/transfer_vectors.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace soffit::prt {

TransferVectors::TransferVectors(const TransferRows& rows)
    : bands_(rows.bands()), channels_(rows.channels()), size_(rows.size()) {
  blocks_.resize(blockCount() * blockStride());
  const std::size_t columns = channels_ * coefficients();
  parallelFor(blockCount(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * kBlock; i < std::min(end * kBlock, size_); ++i) {
      const std::span<const float> row = rows.row(i);
      for (std::size_t c = 0; c < columns; ++c) {
        blocks_[i / kBlock * blockStride() + c * kBlock + i % kBlock] = row[c];
      }
    }
  });
}

}  // namespace soffit::prt
