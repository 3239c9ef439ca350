// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace soffit::photometry {

/// Where an angle lies in an ascending table: between knot `index` and the next, at fraction t.
struct Bracket {
  std::size_t index = 0;
  double t = 0.0;
};

/// Finds the interval of `knots` (strictly ascending, at least two) that holds x; x is clamped to
/// the table. Tables are nearly always equidistant, so the proportional guess is tried first and
/// the binary search is only for the others: the answer is the same.
inline Bracket bracket(std::span<const double> knots, double x) {
  const std::size_t last = knots.size() - 1;
  if (!(x > knots[0])) return {0, 0.0};
  if (x >= knots[last]) return {last - 1, 1.0};
  const double share = (x - knots[0]) / (knots[last] - knots[0]);
  auto index = std::min(static_cast<std::size_t>(share * static_cast<double>(last)), last - 1);
  if (x < knots[index] || x >= knots[index + 1]) {
    const auto above = std::upper_bound(knots.begin(), knots.end(), x);
    index = static_cast<std::size_t>(above - knots.begin()) - 1;
  }
  return {index, (x - knots[index]) / (knots[index + 1] - knots[index])};
}

}  // namespace soffit::photometry
