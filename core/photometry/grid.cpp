// SPDX-License-Identifier: MIT
#include "core/photometry/grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::photometry {
namespace {

int wholePoints(double length, double spacing) {
  return static_cast<int>(std::max(std::lround(length / spacing), 1L));
}

}  // namespace

double gridSpacing(double d) {
  assert(d > 0.0);
  return std::min(0.2 * std::pow(5.0, std::log10(d)), 10.0);
}

GridCounts gridCounts(double u, double v) {
  assert(u > 0.0 && v > 0.0);
  const double longer = std::max(u, v);
  const double shorter = std::min(u, v);
  const double d = longer >= 2.0 * shorter ? shorter : longer;
  const double spacing = d / wholePoints(d, gridSpacing(d));
  return {wholePoints(u, spacing), wholePoints(v, spacing)};
}

}  // namespace soffit::photometry
