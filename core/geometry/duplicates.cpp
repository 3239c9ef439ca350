// SPDX-License-Identifier: MIT
#include "core/geometry/duplicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/geometry/components.h"

namespace soffit::geometry {
namespace {

// The corners turned so that the lowest comes first, and whether they then run upward.
struct SortedCorners {
  uvec3 points;
  bool even;
};

SortedCorners sortCorners(uvec3 c) {
  bool even = true;
  const auto order = [&](std::uint32_t& a, std::uint32_t& b) {
    if (a <= b) return;
    std::swap(a, b);
    even = !even;
  };
  order(c.x, c.y);
  order(c.y, c.z);
  order(c.x, c.y);
  return {c, even};
}

// Of back-to-back pairs (same points, opposite winding), drops the later unless both close solids
// of their own.
void judgePairs(std::span<const vec3> points, std::span<const uvec3> triangles,
                std::span<const std::array<std::uint32_t, 2>> pairs, std::vector<char>& drop) {
  if (pairs.empty()) return;
  Mesh trial;
  trial.positions.assign(points.begin(), points.end());
  for (vec3& p : trial.positions) {
    if (std::isnan(p.x)) p = points[triangles.front().x];  // unused: out of the bounds' way
  }
  std::vector<std::uint32_t> number(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    number[i] = static_cast<std::uint32_t>(trial.triangles.size());
    if (drop[i] == 0) trial.triangles.push_back(triangles[i]);
  }
  const Components components = findComponents(trial);
  for (const auto& [first, second] : pairs) {
    const std::uint32_t a = components.component_of[number[first]];
    const std::uint32_t b = components.component_of[number[second]];
    const bool apart = a != b && components.list[a].solid() && components.list[b].solid();
    if (!apart) drop[second] = 1;
  }
}

}  // namespace

std::vector<char> markDuplicates(std::span<const vec3> points, std::span<const uvec3> triangles) {
  const std::size_t n = triangles.size();
  std::vector<SortedCorners> sorted(n);
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = 0; i < n; ++i) sorted[i] = sortCorners(triangles[i]);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const uvec3 p = sorted[a].points;
    const uvec3 q = sorted[b].points;
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  });
  std::vector<char> drop(n, 0);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t first = 0; first < n;) {
    const std::uint32_t keeper = order[first];
    bool opposite_seen = false;
    std::size_t i = first + 1;
    for (; i < n && sorted[order[i]].points == sorted[keeper].points; ++i) {
      const bool opposite = sorted[order[i]].even != sorted[keeper].even;
      if (opposite && !opposite_seen) {
        opposite_seen = true;
        pairs.push_back({keeper, order[i]});
      } else {
        drop[order[i]] = 1;
      }
    }
    first = i;
  }
  judgePairs(points, triangles, pairs, drop);
  return drop;
}

}  // namespace soffit::geometry
