// SPDX-License-Identifier: MIT
#include "core/geometry/corner_normals.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace soffit::geometry {
namespace {

// Beyond this many triangles about a point the quadratic sum gives way to the face normal.
constexpr std::size_t kMaxFan = 4096;

struct Corner {
  dvec3 face;    // unit normal of its triangle
  double angle;  // radians, at the corner
};

// Corner indices (3 triangle + k) about each point, ascending: compressed rows.
struct Fans {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> corners;
};

Fans fansOf(const WeldedTriangles& mesh) {
  Fans fans;
  fans.begin.assign(mesh.points.size() + 1, 0);
  for (const uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++fans.begin[t[k] + 1];
  }
  for (std::size_t i = 1; i < fans.begin.size(); ++i) fans.begin[i] += fans.begin[i - 1];
  fans.corners.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(fans.begin.begin(), fans.begin.end() - 1);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      fans.corners[next[mesh.triangles[i][static_cast<int>(k)]]++] = 3 * i + k;
    }
  }
  return fans;
}

Corner cornerOf(const WeldedTriangles& mesh, std::size_t triangle, int k) {
  const uvec3 t = mesh.triangles[triangle];
  const dvec3 p(mesh.points[t[k]]);
  const dvec3 a = dvec3(mesh.points[t[(k + 1) % 3]]) - p;
  const dvec3 b = dvec3(mesh.points[t[(k + 2) % 3]]) - p;
  const dvec3 n = glm::cross(a, b);
  const double length = glm::length(n);
  return {n / length, std::atan2(length, glm::dot(a, b))};
}

}  // namespace

std::vector<vec3> cornerNormals(const WeldedTriangles& mesh, double crease_deg) {
  const Fans fans = fansOf(mesh);
  const double least_cosine = std::cos(radians(crease_deg));
  std::vector<Corner> corners(3 * mesh.triangles.size());
  std::vector<vec3> normals(corners.size());
  constexpr std::size_t kGrain = 4096;
  parallelFor(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (int k = 0; k < 3; ++k)
        corners[3 * i + static_cast<std::size_t>(k)] = cornerOf(mesh, i, k);
    }
  });
  parallelFor(corners.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const dvec3 own = corners[i].face;
      const std::uint32_t point = mesh.triangles[i / 3][static_cast<int>(i % 3)];
      const std::span fan =
          std::span(fans.corners)
              .subspan(fans.begin[point], fans.begin[point + 1] - fans.begin[point]);
      dvec3 sum(0.0);
      for (const std::uint32_t j : fan.size() <= kMaxFan ? fan : std::span<const std::uint32_t>{}) {
        const bool same_object = mesh.object_of[j / 3] == mesh.object_of[i / 3];
        if (same_object && glm::dot(own, corners[j].face) >= least_cosine) {
          sum += corners[j].angle * corners[j].face;
        }
      }
      const double length = glm::length(sum);
      normals[i] = vec3(length > 0.0 ? sum / length : own);
    }
  });
  return normals;
}

}  // namespace soffit::geometry
