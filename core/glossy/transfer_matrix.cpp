// SPDX-License-Identifier: MIT
#include "core/glossy/transfer_matrix.h"

#include "core/sh/basis.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace soffit::glossy {
namespace {

/// Calls add(i, j, k, C_ijk) for every order of the indices of every entry, each once.
template <class Add>
void forEachOrder(const sh::TripleProduct& tensor, const Add& add) {
  for (const sh::TripleEntry& e : tensor.entries()) {
    std::array<std::size_t, 3> order{e.i, e.j, e.k};  // ascending
    do {
      add(order[0], order[1], order[2], e.value);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

}  // namespace

std::vector<double> matrixFromBits(const VisibilityBits& bits, std::size_t receiver,
                                   const sh::SphereSamples& samples, int bands) {
  assert(samples.size() == bits.directions());
  const std::size_t n = sh::coefficientCount(bands);
  std::vector<double> matrix(n * n, 0.0);
  std::array<double, sh::kMaxCoefficients> basis;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!bits.open(receiver, k)) continue;
    sh::evaluate(samples.directions[k], bands, basis);
    for (std::size_t i = 0; i < n; ++i) {
      const double wi = samples.weights[k] * basis[i];
      for (std::size_t j = 0; j <= i; ++j) matrix[i * n + j] += wi * basis[j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) matrix[j * n + i] = matrix[i * n + j];
  }
  return matrix;
}

std::vector<double> matrixFromVisibility(std::span<const double> visibility, int bands) {
  const std::size_t n = sh::coefficientCount(bands);
  const std::size_t m = visibility.size();
  std::vector<double> matrix(n * n, 0.0);
  const auto& tensor = sh::TripleProduct::ofBands(std::max(bands, sh::bandsOf(m)));
  forEachOrder(tensor, [&](std::size_t i, std::size_t j, std::size_t k, double c) {
    if (i < n && j < n && k < m) matrix[i * n + j] += c * visibility[k];
  });
  return matrix;
}

std::vector<double> fixedLightMatrix(std::span<const double> light, int visibility_bands) {
  const std::size_t n = light.size();
  const std::size_t m = sh::coefficientCount(visibility_bands);
  std::vector<double> matrix(n * m, 0.0);
  const auto& tensor = sh::TripleProduct::ofBands(std::max(sh::bandsOf(n), visibility_bands));
  forEachOrder(tensor, [&](std::size_t i, std::size_t j, std::size_t k, double c) {
    if (i < n && j < n && k < m) matrix[i * m + k] += c * light[j];
  });
  return matrix;
}

double glossyRadiance(std::span<const double> arriving, std::span<const float> kernel,
                      const dvec3& axis) {
  const int bands = sh::bandsOf(arriving.size());
  assert(kernel.size() >= static_cast<std::size_t>(bands));
  std::array<double, sh::kMaxCoefficients> basis;
  sh::evaluate(axis, bands, basis);
  double sum = 0.0;
  std::size_t i = 0;
  for (std::size_t l = 0; l < static_cast<std::size_t>(bands); ++l) {
    for (; i < (l + 1) * (l + 1); ++i) {
      sum += static_cast<double>(kernel[l]) * arriving[i] * basis[i];
    }
  }
  return sum;
}

}  // namespace soffit::glossy
