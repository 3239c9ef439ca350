// SPDX-License-Identifier: MIT
#include "core/geometry/edge_sides.h"

#include <algorithm>

namespace soffit::geometry {

std::vector<EdgeSide> sortedEdgeSides(std::span<const uvec3> triangles) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const uvec3 p = triangles[t];
    if (p.x == p.y || p.y == p.z || p.z == p.x) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = p[k];
      const std::uint32_t b = p[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, p[(k + 2) % 3], a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    if (a.lo != b.lo) return a.lo < b.lo;
    if (a.hi != b.hi) return a.hi < b.hi;
    return a.triangle < b.triangle;
  });
  return sides;
}

}  // namespace soffit::geometry
