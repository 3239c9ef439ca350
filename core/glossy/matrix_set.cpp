// SPDX-License-Identifier: MIT
#include "core/glossy/matrix_set.h"

#include "core/base/parallel.h"
#include "core/glossy/lobe_shape.h"
#include "core/glossy/matrix_kernels.h"
#include "core/glossy/transfer_matrix.h"
#include "core/sh/kernels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace soffit::glossy {
namespace {

constexpr std::size_t kGrain = 16;  ///< blocks that one task takes

std::size_t elementCount(std::size_t n, bool symmetric) {
  return symmetric ? n * (n + 1) / 2 : n * n;
}

}  // namespace

MatrixSet::MatrixSet(std::size_t receivers, int bands, bool symmetric)
    : bands_(bands),
      symmetric_(symmetric),
      elements_(receivers, elementCount(sh::coefficientCount(bands), symmetric)) {
  assert(sh::coefficientCount(bands) <= kMaxLightCoefficients);
}

std::size_t MatrixSet::rowOf(std::size_t i, std::size_t j) const {
  const std::size_t n = sh::coefficientCount(bands_);
  if (!symmetric_) return i * n + j;
  if (i > j) std::swap(i, j);
  return i * n - i * (i + 1) / 2 + j;  // the rows above hold n, n - 1, .. elements
}

void MatrixSet::set(std::size_t receiver, std::span<const double> matrix) {
  const std::size_t n = sh::coefficientCount(bands_);
  assert(matrix.size() == n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = symmetric_ ? i : 0; j < n; ++j) {
      elements_.at(receiver, rowOf(i, j)) = static_cast<float>(matrix[i * n + j]);
    }
  }
}

float MatrixSet::element(std::size_t receiver, std::size_t row, std::size_t column) const {
  return elements_.at(receiver, rowOf(row, column));
}

void MatrixSet::apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const {
  const std::size_t n = sh::coefficientCount(bands_);
  assert(arriving.receivers() == receivers() && arriving.rows() == 3 * n);
  std::array<float, 3 * kMaxLightCoefficients> values;
  for (std::size_t c = 0; c < 3; ++c) {
    assert(light[c].size() == n);
    for (std::size_t i = 0; i < n; ++i) values[c * n + i] = static_cast<float>(light[c][i]);
  }
  parallelFor(elements_.blocks(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      applyMatrixBlock(elements_.block(b), symmetric_, n, {values.data(), false},
                       arriving.block(b));
    }
  });
}

void MatrixSet::apply(const FloatBlocks& light, FloatBlocks& arriving) const {
  const std::size_t n = sh::coefficientCount(bands_);
  assert(light.receivers() == receivers() && light.rows() == 3 * n);
  assert(arriving.receivers() == receivers() && arriving.rows() == 3 * n);
  parallelFor(elements_.blocks(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      applyMatrixBlock(elements_.block(b), symmetric_, n, {light.block(b), true},
                       arriving.block(b));
    }
  });
}

VisibilitySet::VisibilitySet(std::size_t receivers, int bands)
    : bands_(bands), coefficients_(receivers, sh::coefficientCount(bands)) {}

void VisibilitySet::set(std::size_t receiver, std::span<const double> visibility) {
  assert(visibility.size() == coefficients_.rows());
  for (std::size_t k = 0; k < visibility.size(); ++k) {
    coefficients_.at(receiver, k) = static_cast<float>(visibility[k]);
  }
}

void VisibilitySet::apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const {
  const std::size_t n = light[0].size();
  assert(arriving.receivers() == receivers() && arriving.rows() == 3 * n);
  std::vector<float> matrix;
  for (const sh::Coefficients& channel : light) {
    for (const double f : fixedLightMatrix(channel, bands_)) {
      matrix.push_back(static_cast<float>(f));
    }
  }
  parallelFor(coefficients_.blocks(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      multiplyBlock(matrix.data(), 3 * n, coefficients_.rows(), coefficients_.block(b),
                    arriving.block(b));
    }
  });
}

void shade(const FloatBlocks& arriving, std::span<const LobeView> lobes, std::span<vec3> radiance) {
  assert(lobes.size() == arriving.receivers() && radiance.size() == lobes.size());
  const std::size_t n = arriving.rows() / 3;
  const int bands = sh::bandsOf(n);
  parallelFor(arriving.blocks(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<float, kMaxLightCoefficients * kBlock> basis;
    std::array<std::array<float, kBlock>, 3> axis{};
    std::array<float, 3 * kBlock> values;
    for (std::size_t b = begin; b < end; ++b) {
      const std::size_t first = b * kBlock;
      const std::size_t count = std::min(kBlock, lobes.size() - first);
      for (std::size_t k = 0; k < count; ++k) {
        for (int a = 0; a < 3; ++a) {
          axis[static_cast<std::size_t>(a)][k] = lobes[first + k].axis[a];
        }
      }
      sh::evaluateBatch(axis[0], axis[1], axis[2], bands, kBlock, basis.data());
      for (std::size_t k = 0; k < count; ++k) {
        const auto& kernel = lobeKernel(static_cast<double>(lobes[first + k].alpha));
        std::size_t i = 0;
        for (std::size_t l = 0; i < n; ++l) {
          const float factor = lobes[first + k].weight * kernel[l];
          for (; i < (l + 1) * (l + 1); ++i) basis[i * kBlock + k] *= factor;
        }
      }
      dotBlock(basis.data(), arriving.block(b), n, values.data());
      for (std::size_t k = 0; k < count; ++k) {
        radiance[first + k] = {values[k], values[kBlock + k], values[2 * kBlock + k]};
      }
    }
  });
}

}  // namespace soffit::glossy
