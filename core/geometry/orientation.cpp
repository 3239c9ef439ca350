// SPDX-License-Identifier: MIT
#include "core/geometry/orientation.h"

#include <array>
#include <cstdint>

#include "core/geometry/edge_sides.h"

namespace soffit::geometry {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

// The up to three triangles across edges that two triangles share.
struct Neighbors {
  std::array<std::uint32_t, 3> triangle{kNone, kNone, kNone};
  std::array<bool, 3> agrees{};  // opposite directions along the common edge
  int count = 0;

  void add(std::uint32_t other, bool agree) {
    triangle[static_cast<std::size_t>(count)] = other;
    agrees[static_cast<std::size_t>(count++)] = agree;
  }
};

std::vector<Neighbors> neighborsOf(std::span<const uvec3> triangles) {
  std::vector<Neighbors> out(triangles.size());
  const std::vector<EdgeSide> sides = sortedEdgeSides(triangles);
  forEachEdge(sides, [&](std::span<const EdgeSide> edge) {
    if (edge.size() != 2) return;
    const bool agree = edge[0].forward != edge[1].forward;
    out[edge[0].triangle].add(edge[1].triangle, agree);
    out[edge[1].triangle].add(edge[0].triangle, agree);
  });
  return out;
}

// A part, found from one triangle on.
struct Part {
  std::vector<std::uint32_t> triangles;
  bool orientable = true;
  bool closed = true;
};

// Floods one part; turned[t] becomes 1 where t disagrees with the seed.
Part flood(std::uint32_t seed, const std::vector<Neighbors>& neighbors, std::vector<char>& visited,
           std::vector<char>& turned) {
  Part part{.triangles = {seed}};
  visited[seed] = 1;
  for (std::size_t next = 0; next < part.triangles.size(); ++next) {
    const std::uint32_t t = part.triangles[next];
    const Neighbors& around = neighbors[t];
    if (around.count < 3) part.closed = false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(around.count); ++k) {
      const std::uint32_t other = around.triangle[k];
      const char wanted = around.agrees[k] ? turned[t] : static_cast<char>(1 - turned[t]);
      if (visited[other] == 0) {
        visited[other] = 1;
        turned[other] = wanted;
        part.triangles.push_back(other);
      } else if (turned[other] != wanted) {
        part.orientable = false;
      }
    }
  }
  return part;
}

struct Measures {
  double volume = 0.0;  // m3, as turned; of closed parts
  double area = 0.0;    // m2
  double turned_area = 0.0;
};

Measures measure(const Part& part, std::span<const vec3> points, std::span<const uvec3> triangles,
                 const std::vector<char>& turned) {
  Measures out;
  const dvec3 middle(points[triangles[part.triangles[0]].x]);
  for (const std::uint32_t t : part.triangles) {
    const dvec3 a = dvec3(points[triangles[t].x]) - middle;
    const dvec3 b = dvec3(points[triangles[t].y]) - middle;
    const dvec3 c = dvec3(points[triangles[t].z]) - middle;
    const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    out.volume += turned[t] != 0 ? -volume : volume;
    out.area += area;
    if (turned[t] != 0) out.turned_area += area;
  }
  return out;
}

}  // namespace

std::vector<char> findTurned(std::span<const vec3> points, std::span<const uvec3> triangles) {
  const std::vector<Neighbors> neighbors = neighborsOf(triangles);
  std::vector<char> visited(triangles.size(), 0);
  std::vector<char> turned(triangles.size(), 0);
  for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
    if (visited[seed] != 0) continue;
    const Part part = flood(seed, neighbors, visited, turned);
    const Measures sizes = measure(part, points, triangles, turned);
    if (sizes.turned_area == 0.0 && part.orientable) continue;
    const bool invert = part.closed ? sizes.volume < 0.0 : sizes.turned_area > 0.5 * sizes.area;
    for (const std::uint32_t t : part.triangles) {
      if (!part.orientable) turned[t] = 0;
      if (part.orientable && invert) turned[t] = static_cast<char>(1 - turned[t]);
    }
  }
  return turned;
}

}  // namespace soffit::geometry
