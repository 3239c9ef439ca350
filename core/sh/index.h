// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

/// Numbering and sign convention of the real spherical harmonics, in this one place.
///
/// y_lm is orthonormal over the unit sphere, z is the pole, and there is NO Condon-Shortley sign
/// (-1)^m: y_11 is +sqrt(3/4pi) x. Negative orders are the sines: y_{l,-m} ~ sin(m phi). Fujita &
/// Kanai 2004 (Table 3) and Sloan 2013 (with his signs dropped) use the same functions; the
/// tutorial's listing (Slomp, Oliveira, Patricio) and Green 2003 carry the sign: condonShortley().
namespace soffit::sh {

/// Bands 0 .. kMaxBands-1 are supported everywhere.
inline constexpr int kMaxBands = 10;
inline constexpr std::size_t kMaxCoefficients = std::size_t{kMaxBands} * kMaxBands;

/// Coefficients of a function, n^2 numbers at index l(l + 1) + m; the unit is that of the
/// function times sr^1/2.
using Coefficients = std::vector<double>;

/// The same for red, green and blue (linear Rec.709).
using RgbCoefficients = std::array<Coefficients, 3>;

/// n^2 coefficients belong to n bands.
constexpr std::size_t coefficientCount(int bands) {
  return static_cast<std::size_t>(bands) * static_cast<std::size_t>(bands);
}

/// Number of bands that `count` coefficients span; count must be a square.
constexpr int bandsOf(std::size_t count) {
  int bands = 0;
  while (coefficientCount(bands) < count) ++bands;
  assert(coefficientCount(bands) == count);
  return bands;
}

/// Place of y_lm, -l <= m <= l.
constexpr std::size_t index(int l, int m) {
  assert(-l <= m && m <= l);
  return static_cast<std::size_t>(l * (l + 1) + m);
}

/// Degree l of the coefficient at `i`.
constexpr int degreeOf(std::size_t i) {
  int l = 0;
  while (coefficientCount(l + 1) <= i) ++l;
  return l;
}

/// Order m of the coefficient at `i`.
constexpr int orderOf(std::size_t i) {
  const int l = degreeOf(i);
  return static_cast<int>(i) - l * (l + 1);
}

/// The factor (-1)^m between our coefficient at `i` and one with the Condon-Shortley sign.
constexpr double condonShortley(std::size_t i) {
  return orderOf(i) % 2 == 0 ? 1.0 : -1.0;
}

static_assert(index(4, -4) == 16 && degreeOf(24) == 4 && orderOf(24) == 4 && bandsOf(25) == 5);

}  // namespace soffit::sh
