// SPDX-License-Identifier: MIT
#include "core/photometry/metrics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace soffit::photometry {

FieldMetrics fieldMetrics(std::span<const double> values) {
  FieldMetrics m;
  if (values.empty()) return m;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  m.count = values.size();
  m.min = *low;
  m.max = *high;
  m.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(m.count);
  if (m.mean > 0.0) m.u0 = m.min / m.mean;
  if (m.max > 0.0) m.ud = m.min / m.max;
  return m;
}

double percentile(std::span<const double> values, double fraction) {
  if (values.empty()) return 0.0;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

}  // namespace soffit::photometry
