// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/kernels.h"
#include "core/sh/index.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soffit::prt {

/// Transfer vectors as they are baked: a row of floats per receiver, n^2 coefficients for each of
/// one or three channels, then zeros up to the stride.
///
/// E = sum over i of L_i T_i is the receiver's irradiance in lux when the light's coefficients L
/// are of cd/m^2 (world axes, core/sh/index.h); T is in sr, without the receiver's own reflectance.
/// Three channels where light has bounced off coloured surfaces.
class TransferRows {
 public:
  TransferRows() = default;
  TransferRows(std::size_t receivers, int bands, std::size_t channels)
      : bands_(bands),
        channels_(channels),
        size_(receivers),
        stride_(rowStrideOf(channels * sh::coefficientCount(bands))),
        rows_(receivers * stride_, 0.0F) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t channels() const { return channels_; }
  [[nodiscard]] std::size_t coefficients() const { return sh::coefficientCount(bands_); }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] std::size_t bytes() const { return rows_.size() * sizeof(float); }

  [[nodiscard]] std::span<float> row(std::size_t receiver) {
    return {rows_.data() + receiver * stride_, stride_};
  }
  [[nodiscard]] std::span<const float> row(std::size_t receiver) const {
    return {rows_.data() + receiver * stride_, stride_};
  }
  /// One channel's coefficients; a grey row answers for any.
  [[nodiscard]] std::span<const float> vector(std::size_t receiver, std::size_t channel = 0) const {
    const std::size_t at = channels_ == 1 ? 0 : channel * coefficients();
    return row(receiver).subspan(at, coefficients());
  }
  [[nodiscard]] const float* data() const { return rows_.data(); }

 private:
  int bands_ = 0;
  std::size_t channels_ = 1;
  std::size_t size_ = 0;
  std::size_t stride_ = 0;
  std::vector<float> rows_;
};

}  // namespace soffit::prt
