// SPDX-License-Identifier: MIT
#include "core/color/exposure.h"

#include "core/color/luminance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::color {

float exposureScale(double exposure_ev) {
  return static_cast<float>(std::exp2(exposure_ev) / kReferenceLuminance);
}

double autoExposure(std::span<const vec3> radiance) {
  std::vector<float> stops;
  stops.reserve(radiance.size());
  for (const vec3& rgb : radiance) {
    const float y = luminance(rgb);
    if (y > 0.0F && std::isfinite(y)) stops.push_back(std::log2(y));
  }
  if (stops.empty()) return 0.0;
  const std::size_t kept = std::max<std::size_t>(stops.size() - stops.size() / 100, 1);
  std::nth_element(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(kept - 1),
                   stops.end());
  // Sorted, so that the sum does not depend on how nth_element left the order.
  std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(kept));
  double sum = 0.0;
  for (std::size_t i = 0; i < kept; ++i) sum += static_cast<double>(stops[i]);
  const double mean = sum / static_cast<double>(kept);
  return std::clamp(std::log2(kMidGrey * kReferenceLuminance) - mean, -20.0, 20.0);
}

}  // namespace soffit::color
