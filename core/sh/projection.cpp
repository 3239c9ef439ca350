// SPDX-License-Identifier: MIT
#include "core/sh/projection.h"

#include "core/sh/kernels.h"

#include <algorithm>
#include <cassert>

namespace soffit::sh {

ProjectionTable::ProjectionTable(const SphereSamples& samples, int bands)
    : bands_(bands),
      count_(samples.size()),
      stride_((count_ + kKernelBlock - 1) / kKernelBlock * kKernelBlock),
      table_(stride_ * coefficientCount(bands), 0.0F) {
  assert(bands >= 1 && bands <= kMaxBands);
  std::array<double, kMaxCoefficients> basis;
  for (std::size_t k = 0; k < count_; ++k) {
    evaluate(samples.directions[k], bands, basis);
    for (std::size_t i = 0; i < coefficientCount(bands); ++i) {
      table_[i * stride_ + k] = static_cast<float>(basis[i] * samples.weights[k]);
    }
  }
}

Coefficients ProjectionTable::project(std::span<const float> values) const {
  assert(values.size() == count_);
  Coefficients sum(coefficientCount(bands_));
  const std::array<std::span<const float>, 1> channels{values};
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sumOfProducts(table_.data() + i * stride_, channels, &sum[i]);
  }
  return sum;
}

RgbCoefficients ProjectionTable::project(std::span<const float> red, std::span<const float> green,
                                         std::span<const float> blue) const {
  assert(red.size() == count_ && green.size() == count_ && blue.size() == count_);
  RgbCoefficients sum;
  for (Coefficients& channel : sum) channel.resize(coefficientCount(bands_));
  const std::array<std::span<const float>, 3> channels{red, green, blue};
  for (std::size_t i = 0; i < coefficientCount(bands_); ++i) {
    std::array<double, 3> sums{};
    sumOfProducts(table_.data() + i * stride_, channels, sums.data());
    for (std::size_t c = 0; c < 3; ++c) sum[c][i] = sums[c];
  }
  return sum;
}

}  // namespace soffit::sh
