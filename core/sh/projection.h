// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/basis.h"
#include "core/sh/sphere_samples.h"

#include <array>
#include <span>
#include <type_traits>
#include <vector>

/// Projection c_lm = integral f(d) y_lm(d) d omega of functions and of tables of values.
namespace soffit::sh {

namespace detail {
inline void accumulate(double value, double weighted_basis, std::size_t i, Coefficients& to) {
  to[i] += value * weighted_basis;
}
inline void accumulate(const dvec3& value, double weighted_basis, std::size_t i,
                       RgbCoefficients& to) {
  to[0][i] += value.x * weighted_basis;
  to[1][i] += value.y * weighted_basis;
  to[2][i] += value.z * weighted_basis;
}
inline void clear(Coefficients& c, int bands) {
  c.assign(coefficientCount(bands), 0.0);
}
inline void clear(RgbCoefficients& c, int bands) {
  for (Coefficients& channel : c) clear(channel, bands);
}
}  // namespace detail

/// Projects a function on the sphere with a set of samples.
///
/// f      dvec3 (unit direction, z up) -> double or dvec3 (three channels), finite everywhere.
/// bands  1 .. kMaxBands.
/// return Coefficients or RgbCoefficients, unit [f] sr^1/2.
///
/// With cubature(degree) exact up to rounding where f has no degree above degree - (bands - 1);
/// what lies above aliases. With Monte Carlo samples the error is statistical.
template <class F>
auto project(const F& f, const SphereSamples& samples, int bands) {
  using Value = std::remove_cvref_t<decltype(f(dvec3()))>;
  std::conditional_t<std::is_same_v<Value, dvec3>, RgbCoefficients, Coefficients> sum;
  detail::clear(sum, bands);
  std::array<double, kMaxCoefficients> basis;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    evaluate(samples.directions[k], bands, basis);
    const Value value = f(samples.directions[k]);
    for (std::size_t i = 0; i < coefficientCount(bands); ++i) {
      detail::accumulate(value, basis[i] * samples.weights[k], i, sum);
    }
  }
  return sum;
}

/// Basis times weight, stored for each of a set of samples, for functions that are projected again
/// and again on the same directions: the tutorial's cached samples, Fujita & Kanai's table per
/// texel of a cube map. 4 bytes x samples x bands^2 (64^2 x 6 texels, 5 bands: 2.5 MB).
class ProjectionTable {
 public:
  /// bands in 1 .. kMaxBands.
  ProjectionTable(const SphereSamples& samples, int bands);

  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t sampleCount() const { return count_; }
  [[nodiscard]] std::size_t bytes() const { return table_.size() * sizeof(float); }

  /// values[k]: the function at sample k, values.size() == sampleCount(). Products are summed in
  /// single precision over blocks of 256 samples, blocks in double: relative error about 1e-6 of
  /// the integral of |f y_lm|. SIMD; the same on every number of threads.
  [[nodiscard]] Coefficients project(std::span<const float> values) const;
  /// The same for three channels, one pass over the table.
  [[nodiscard]] RgbCoefficients project(std::span<const float> red, std::span<const float> green,
                                        std::span<const float> blue) const;

 private:
  int bands_;
  std::size_t count_;
  std::size_t stride_;        ///< floats per coefficient: count_ rounded up to whole blocks
  std::vector<float> table_;  ///< [coefficient][sample], zero beyond count_
};

}  // namespace soffit::sh
