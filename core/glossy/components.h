// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::glossy {

/// The leading principal components of some vectors about their mean.
struct Components {
  std::vector<float> mean;
  std::vector<float> rows;        ///< orthonormal, by falling variance
  std::vector<double> variances;  ///< per row: sum of squared coefficients
  double total = 0.0;             ///< sum of squared distances from the mean
};

/// members: indices of rows of `vectors` (row-major, `dimension` wide), at least one. At most
/// `rank` components, fewer where members or dimensions are fewer or the rest is rounding. Subspace
/// iteration with Rayleigh-Ritz (Golub & Van Loan, 8.2.4), 8 steps over 4 rows more than asked for.
Components principalComponents(std::span<const float> vectors, std::size_t dimension,
                               std::span<const std::uint32_t> members, std::size_t rank);

/// Sum of a[i] b[i], eight sums side by side.
float dot(const float* a, const float* b, std::size_t n);

}  // namespace soffit::glossy
