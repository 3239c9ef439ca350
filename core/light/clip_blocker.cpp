// SPDX-License-Identifier: MIT
#include "core/light/clip_blocker.h"

#include <array>
#include <cmath>

namespace soffit::light {

MaskBlocker clipToFront(const MaskBlocker& blocker, const vec3& n, float d) {
  std::array<float, 5> height{};
  bool all = true;
  bool none = true;
  // How far a corner may stand on the wrong side by rounding alone.
  const float tolerance = 2e-7F * (std::abs(d) + 1.0F);
  for (int i = 0; i < blocker.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    height[k] = glm::dot(n, blocker.corners[k]) - d;
    all = all && height[k] >= -tolerance;
    none = none && height[k] <= tolerance;
  }
  if (none) {
    MaskBlocker empty = blocker;
    empty.count = 0;
    return empty;
  }
  if (all) return blocker;
  MaskBlocker out = blocker;
  out.count = 0;
  for (int i = 0; i < blocker.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>((i + 1) % blocker.count);
    // A corner on the plane stays and makes no crossing beside it: an edge without length would
    // have no side, and the piece would hide nothing.
    if (height[k] >= -tolerance && out.count < 5) {
      out.corners[static_cast<std::size_t>(out.count++)] = blocker.corners[k];
    }
    const bool crosses = (height[k] > tolerance && height[next] < -tolerance) ||
                         (height[k] < -tolerance && height[next] > tolerance);
    if (crosses && out.count < 5) {
      const float t = height[k] / (height[k] - height[next]);
      out.corners[static_cast<std::size_t>(out.count++)] =
          blocker.corners[k] + t * (blocker.corners[next] - blocker.corners[k]);
    }
  }
  return out;
}

}  // namespace soffit::light
