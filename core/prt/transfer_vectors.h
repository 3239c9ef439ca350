// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/transfer_rows.h"
#include "core/transfer/half.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::prt {

/// Transfer vectors as they are evaluated: halves, in blocks of kBlock receivers, coefficient by
/// coefficient within a block, so that evaluation reads memory front to back and fewer bands read
/// the front of each block alone. Relative rounding of a coefficient at most 2^-11: RMS of E
/// against floats 1e-4 (measured by tests). Immutable.
class TransferVectors {
 public:
  TransferVectors() = default;
  explicit TransferVectors(const TransferRows& rows);

  /// What so many receivers will take.
  static std::uint64_t predictBytes(std::uint64_t receivers, int bands, std::uint64_t channels) {
    return (receivers + kBlock - 1) / kBlock * kBlock * channels * sh::coefficientCount(bands) *
           sizeof(transfer::Half);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t channels() const { return channels_; }
  [[nodiscard]] std::size_t coefficients() const { return sh::coefficientCount(bands_); }
  [[nodiscard]] std::uint64_t bytes() const { return blocks_.size() * sizeof(transfer::Half); }
  [[nodiscard]] std::size_t blockCount() const { return (size_ + kBlock - 1) / kBlock; }
  /// Halves from one block to the next; channel c of a block starts c * coefficients() * kBlock in.
  [[nodiscard]] std::size_t blockStride() const { return channels_ * coefficients() * kBlock; }
  [[nodiscard]] std::span<const transfer::Half> blocks() const { return blocks_; }

  /// One coefficient of a receiver; a grey one answers for any channel.
  [[nodiscard]] float at(std::size_t receiver, std::size_t channel, std::size_t i) const {
    const std::size_t c = channels_ == 1 ? 0 : channel;
    return blocks_[receiver / kBlock * blockStride() + (c * coefficients() + i) * kBlock +
                   receiver % kBlock];
  }

 private:
  int bands_ = 1;
  std::size_t channels_ = 1;
  std::size_t size_ = 0;
  std::vector<transfer::Half> blocks_;
};

}  // namespace soffit::prt
