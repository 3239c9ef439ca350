// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"

#include <span>
#include <vector>

/// Turning functions on the sphere: bands stay apart, each by a matrix of its own.
namespace soffit::sh {

/// A rotation R as it acts on coefficients: the turned function is f(R^-1 d), so that light from
/// direction d comes from R d afterwards.
///
/// The matrices follow from those of bands 1 and l-1 by polynomials in R's elements (Ivanic &
/// Ruedenberg 1996, with the additions and corrections of 1998), hence no angle is special.
/// Orthogonal to 1e-13 at 10 bands.
class Rotation {
 public:
  /// `matrix` is orthonormal with determinant 1 (columns: where x, y, z go); bands 1 .. kMaxBands.
  Rotation(const dmat3& matrix, int bands);

  [[nodiscard]] int bands() const { return bands_; }

  /// Coefficients of the turned function; coefficients.size() <= bands()^2, a square.
  [[nodiscard]] Coefficients apply(std::span<const double> coefficients) const;
  /// Turned back: by the transposed matrices.
  [[nodiscard]] Coefficients applyInverse(std::span<const double> coefficients) const;

  /// Element of band l, row m, column n.
  [[nodiscard]] double element(int l, int m, int n) const {
    return elements_[offset(l) + static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)];
  }

 private:
  /// Sum of (2k + 1)^2 over k < l.
  static std::size_t offset(int l) { return static_cast<std::size_t>(l * (4 * l * l - 1) / 3); }
  void addBand(int l, const std::vector<double>& first);

  int bands_;
  std::vector<double> elements_;
};

/// Turns by `angle` radians about +z, counter-clockwise seen from above: pairs (m, -m) turn by
/// m angle. Takes a few nanoseconds a coefficient; this is how the sky is turned round a building.
Coefficients rotateAboutZ(std::span<const double> coefficients, double angle);

}  // namespace soffit::sh
