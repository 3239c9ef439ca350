// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/index.h"

#include <cstdint>
#include <span>
#include <vector>

/// Products of functions given by coefficients: light times visibility, light times BRDF.
namespace soffit::sh {

/// C_ijk = integral y_i y_j y_k with i <= j <= k.
struct TripleEntry {
  std::uint16_t i = 0, j = 0, k = 0;
  double value = 0.0;
};

/// The symmetric, sparse tensor C_ijk for a number of bands (Ng et al. 2004; Dhawal et al. 2022),
/// each of its different values once, in the order i, j, k; zeros by the selection rules (orders
/// that do not add up, odd l1 + l2 + l3, no triangle) are left out exactly, never by a threshold.
/// Gauss-Legendre and equally spaced azimuths of sufficient degree: exact to rounding.
/// 1 .. kMaxBands; made once per number of bands, then shared.
class TripleProduct {
 public:
  static const TripleProduct& ofBands(int bands);

  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::span<const TripleEntry> entries() const { return entries_; }
  /// C_ijk for any order of indices; 0 where it has none.
  [[nodiscard]] double at(std::size_t i, std::size_t j, std::size_t k) const;

  /// Projection of the product of two functions onto the same bands:
  /// c_k = sum C_ijk a_i b_j. What lies above the bands is cut off. Three spans of bands()^2; c
  /// must not be a or b.
  void multiply(std::span<const double> a, std::span<const double> b, std::span<double> c) const;
  void multiply(std::span<const float> a, std::span<const float> b, std::span<float> c) const;

  /// Many products at once, SIMD: coefficient i of item k at [i * stride + k], n <= stride items.
  void multiplyBatch(const float* a, const float* b, float* c, std::size_t n,
                     std::size_t stride) const;

  /// The matrix M_kj = sum_i C_ijk f_i by which the fixed function f (light, say) multiplies
  /// others: M b = f b (TPFL; Sloan 2008). Row-major, bands()^2 squared, symmetric.
  [[nodiscard]] std::vector<double> matrixOf(std::span<const double> f) const;

 private:
  explicit TripleProduct(int bands);

  int bands_;
  std::vector<TripleEntry> entries_;
};

/// c = M b for a row-major square matrix of b.size() rows; c must not be b.
void multiplyByMatrix(std::span<const float> matrix, std::span<const float> b, std::span<float> c);

/// The same for many b at once, SIMD: coefficient i of item k at [i * stride + k], n <= stride items
/// of `coefficients` each; c must not be b.
void multiplyByMatrixBatch(std::span<const float> matrix, std::size_t coefficients, const float* b,
                           float* c, std::size_t n, std::size_t stride);

/// integral of the product of two functions: the dot product of their coefficients.
double innerProduct(std::span<const double> a, std::span<const double> b);

}  // namespace soffit::sh
