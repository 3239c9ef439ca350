// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/receiver_blocks.h"
#include "core/math/vec.h"
#include "core/sh/index.h"

#include <span>

/// The transfer matrices of many receivers, and light through all of them at once.
///
/// Storage is binary16 (relative error 2^-11 an element). Light is RGB: three sets of n^2
/// coefficients; what arrives is 3 n^2 rows a receiver, channel by channel. All functions run on
/// all threads and give the same on any number of them.
namespace soffit::glossy {

class MatrixSet {
 public:
  /// bands in 1 .. 6. symmetric: matrices of visibility, of which the upper triangle is kept (325
  /// of 625 elements at 5 bands); matrices with reflected light are not symmetric.
  MatrixSet(std::size_t receivers, int bands, bool symmetric);

  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t receivers() const { return elements_.receivers(); }
  [[nodiscard]] std::size_t bytes() const { return elements_.bytes(); }

  /// matrix: row-major, n^2 x n^2. Different receivers of one block of 16 may be set at the same
  /// time.
  void set(std::size_t receiver, std::span<const double> matrix);
  [[nodiscard]] float element(std::size_t receiver, std::size_t row, std::size_t column) const;

  /// One light for all receivers (distant, or of one probe). arriving: 3 n^2 rows.
  void apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const;
  /// Light of its own for every receiver, 3 n^2 rows.
  void apply(const FloatBlocks& light, FloatBlocks& arriving) const;

 private:
  [[nodiscard]] std::size_t rowOf(std::size_t i, std::size_t j) const;
  int bands_;
  bool symmetric_;
  HalfBlocks elements_;
};

/// Visibility of many receivers as coefficients, and one light through all of it by the fixed-light
/// matrix: for 81 coefficients of visibility and 25 of light a quarter of the memory of symmetric
/// matrices, and the same result.
class VisibilitySet {
 public:
  VisibilitySet(std::size_t receivers, int bands);
  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t receivers() const { return coefficients_.receivers(); }
  [[nodiscard]] std::size_t bytes() const { return coefficients_.bytes(); }
  void set(std::size_t receiver, std::span<const double> visibility);

  /// light: n^2 coefficients per channel, n <= 6; arriving: 3 n^2 rows.
  void apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const;

 private:
  int bands_;
  HalfBlocks coefficients_;
};

/// A lobe per receiver, as it is looked at.
struct LobeView {
  vec3 axis{0.0F, 0.0F, 1.0F};  ///< unit
  float alpha = 0.25F;          ///< of the round lobe (LobeShape)
  float weight = 1.0F;          ///< reflectance over share above the surface
};

/// Radiance of each receiver toward the eye: weight times glossyRadiance() of its 3 n^2 rows.
/// radiance.size() == lobes.size() == arriving.receivers(). Float; error 1e-6 of the coefficients.
void shade(const FloatBlocks& arriving, std::span<const LobeView> lobes, std::span<vec3> radiance);

}  // namespace soffit::glossy
