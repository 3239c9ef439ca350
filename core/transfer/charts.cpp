// SPDX-License-Identifier: MIT
#include "core/transfer/charts.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace soffit::transfer {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

struct TriangleFrame {
  vec3 normal{0.0F};
  float area = 0.0F;
};

std::vector<TriangleFrame> framesOf(const geometry::Mesh& mesh) {
  std::vector<TriangleFrame> frames(mesh.triangles.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const uvec3& t = mesh.triangles[i];
    const dvec3 a(mesh.positions[t.x]);
    const dvec3 n = glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a);
    const double length = glm::length(n);
    frames[i].area = static_cast<float>(0.5 * length);
    if (length > 0.0) frames[i].normal = vec3(n / length);
  }
  return frames;
}

/// Vertices at the same place get the same number.
std::vector<std::uint32_t> weldByPosition(const geometry::Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const vec3& p = mesh.positions[a];
    const vec3& q = mesh.positions[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  };
  std::sort(order.begin(), order.end(), less);
  std::vector<std::uint32_t> id(mesh.positions.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.positions[order[i]] == mesh.positions[order[i - 1]];
    id[order[i]] = same ? id[order[i - 1]] : order[i];
  }
  return id;
}

/// Triangles that share an edge with each triangle, in compressed rows.
struct Adjacency {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> neighbors;
};

Adjacency adjacencyOf(const geometry::Mesh& mesh) {
  struct Edge {
    std::uint32_t a, b, triangle;
    bool operator<(const Edge& o) const {
      if (a != o.a) return a < o.a;
      if (b != o.b) return b < o.b;
      return triangle < o.triangle;
    }
  };
  const std::vector<std::uint32_t> weld = weldByPosition(mesh);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = weld[mesh.triangles[i][k]];
      const std::uint32_t b = weld[mesh.triangles[i][(k + 1) % 3]];
      edges.push_back({std::min(a, b), std::max(a, b), i});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b) ++j;
    for (std::size_t k = i; k + 1 < j; ++k) {
      pairs.push_back({edges[k].triangle, edges[k + 1].triangle});
      pairs.push_back({edges[k + 1].triangle, edges[k].triangle});
    }
    i = j;
  }
  std::sort(pairs.begin(), pairs.end());
  Adjacency adjacency;
  adjacency.offsets.assign(mesh.triangles.size() + 1, 0);
  for (const auto& p : pairs) ++adjacency.offsets[p[0] + 1];
  std::partial_sum(adjacency.offsets.begin(), adjacency.offsets.end(), adjacency.offsets.begin());
  for (const auto& p : pairs) adjacency.neighbors.push_back(p[1]);
  return adjacency;
}

class ChartMaker {
 public:
  ChartMaker(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell)
      : mesh_(mesh), sides_(sides), cell_area_(cell * cell), frames_(framesOf(mesh)), adjacency_(adjacencyOf(mesh)) {
    const float size = mesh.bounds().diagonal();
    plane_tolerance_ = 2e-6F * size + 1e-6F;
  }

  Charts make() {
    result_.chart_of.assign(mesh_.triangles.size(), kNone);
    small_of_.assign(mesh_.triangles.size(), kNone);
    std::vector<std::vector<std::uint32_t>> small;
    for (std::uint32_t seed = 0; seed < mesh_.triangles.size(); ++seed) {
      if (result_.chart_of[seed] != kNone || small_of_[seed] != kNone) continue;
      std::vector<std::uint32_t> region = flood(seed);
      double area = 0.0;
      for (const std::uint32_t t : region) area += static_cast<double>(frames_[t].area);
      if (area >= 0.5 * cell_area_) {
        addPlanar(region, area);
      } else {
        for (const std::uint32_t t : region) small_of_[t] = static_cast<std::uint32_t>(small.size());
        small.push_back(std::move(region));
      }
    }
    mergeSmall(small);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool alike(std::uint32_t a, std::uint32_t b) const {
    return mesh_.material_of[a] == mesh_.material_of[b] && sides_[a] == sides_[b];
  }

  /// Connected triangles in the seed's plane with the same front.
  std::vector<std::uint32_t> flood(std::uint32_t seed) {
    std::vector<std::uint32_t> region{seed};
    const vec3 n = frames_[seed].normal;
    const float d = glm::dot(n, mesh_.positions[mesh_.triangles[seed].x]);
    marks_.resize(mesh_.triangles.size(), kNone);
    marks_[seed] = seed;
    for (std::size_t head = 0; head < region.size(); ++head) {
      const std::uint32_t t = region[head];
      for (std::uint32_t k = adjacency_.offsets[t]; k < adjacency_.offsets[t + 1]; ++k) {
        const std::uint32_t other = adjacency_.neighbors[k];
        if (marks_[other] == seed || result_.chart_of[other] != kNone || small_of_[other] != kNone) continue;
        if (!alike(seed, other) || !inPlane(other, n, d)) continue;
        marks_[other] = seed;
        region.push_back(other);
      }
    }
    return region;
  }

  [[nodiscard]] bool inPlane(std::uint32_t t, const vec3& n, float d) const {
    if (glm::dot(frames_[t].normal, n) < 0.9999F) return false;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(glm::dot(n, mesh_.positions[mesh_.triangles[t][k]]) - d) > plane_tolerance_) return false;
    }
    return true;
  }

  Chart& append(std::span<const std::uint32_t> region, double area) {
    Chart chart;
    chart.sides = sides_[region.front()];
    chart.material = mesh_.material_of[region.front()];
    chart.area = area;
    chart.first_triangle = static_cast<std::uint32_t>(result_.triangles.size());
    chart.triangle_count = static_cast<std::uint32_t>(region.size());
    for (const std::uint32_t t : region) {
      result_.triangles.push_back(t);
      result_.chart_of[t] = static_cast<std::uint32_t>(result_.charts.size());
    }
    result_.charts.push_back(chart);
    return result_.charts.back();
  }

  void addPlanar(const std::vector<std::uint32_t>& region, double area) {
    Chart& chart = append(region, area);
    dvec3 n(0.0);
    for (const std::uint32_t t : region) n += dvec3(frames_[t].normal) * static_cast<double>(frames_[t].area);
    chart.normal = vec3(glm::normalize(n));
    setAxes(chart, region);
  }

  /// Axes along the longest edge of the region (walls and desks are mostly rectangles).
  void setAxes(Chart& chart, std::span<const std::uint32_t> region) const {
    vec3 along(0.0F);
    float longest = 0.0F;
    for (const std::uint32_t t : region) {
      for (int k = 0; k < 3; ++k) {
        const vec3 e = mesh_.positions[mesh_.triangles[t][(k + 1) % 3]] - mesh_.positions[mesh_.triangles[t][k]];
        // An edge between two triangles of the region is most likely a rectangle's diagonal:
        // axis-parallel edges win by a bonus.
        const vec3 a = glm::abs(e);
        const float axis = std::max({a.x, a.y, a.z});
        const float length = glm::length(e);
        const float score = length * (axis > 0.9999F * length ? 4.0F : 1.0F);
        if (score > longest * 1.0001F) {
          longest = score;
          along = e;
        }
      }
    }
    along -= glm::dot(along, chart.normal) * chart.normal;
    chart.t = glm::normalize(along);
    chart.b = glm::cross(chart.normal, chart.t);
    dvec2 lo(std::numeric_limits<double>::infinity());
    dvec2 hi(-std::numeric_limits<double>::infinity());
    const dvec3 anchor(mesh_.positions[mesh_.triangles[region.front()].x]);
    for (const std::uint32_t t : region) {
      for (int k = 0; k < 3; ++k) {
        const dvec3 p = dvec3(mesh_.positions[mesh_.triangles[t][k]]) - anchor;
        const dvec2 q(glm::dot(p, dvec3(chart.t)), glm::dot(p, dvec3(chart.b)));
        lo = glm::min(lo, q);
        hi = glm::max(hi, q);
      }
    }
    chart.origin = vec3(anchor + lo.x * dvec3(chart.t) + lo.y * dvec3(chart.b));
    chart.size = vec2(hi - lo);
  }

  /// Joins small coplanar regions across their edges while the normals stay within 40 degrees
  /// of the seed's and the area within one cell.
  void mergeSmall(const std::vector<std::vector<std::uint32_t>>& small) {
    std::vector<bool> taken(small.size(), false);
    for (std::uint32_t seed = 0; seed < small.size(); ++seed) {
      if (taken[seed]) continue;
      taken[seed] = true;
      std::vector<std::uint32_t> members{seed};
      std::vector<std::uint32_t> triangles = small[seed];
      double area = areaOf(small[seed]);
      const vec3 n = frames_[small[seed].front()].normal;
      for (std::size_t head = 0; head < members.size(); ++head) {
        for (const std::uint32_t t : small[members[head]]) {
          for (std::uint32_t k = adjacency_.offsets[t]; k < adjacency_.offsets[t + 1]; ++k) {
            const std::uint32_t other = small_of_[adjacency_.neighbors[k]];
            if (other == kNone || taken[other]) continue;
            const std::uint32_t first = small[other].front();
            if (!alike(t, first) || glm::dot(frames_[first].normal, n) < 0.766F) continue;
            const double more = areaOf(small[other]);
            if (area + more > cell_area_) continue;
            taken[other] = true;
            area += more;
            members.push_back(other);
            triangles.insert(triangles.end(), small[other].begin(), small[other].end());
          }
        }
      }
      addCurved(triangles, area);
    }
  }

  [[nodiscard]] double areaOf(const std::vector<std::uint32_t>& region) const {
    double area = 0.0;
    for (const std::uint32_t t : region) area += static_cast<double>(frames_[t].area);
    return area;
  }

  void addCurved(const std::vector<std::uint32_t>& triangles, double area) {
    Chart& chart = append(triangles, area);
    chart.planar = false;
    dvec3 n(0.0);
    for (const std::uint32_t t : triangles) n += dvec3(frames_[t].normal) * static_cast<double>(frames_[t].area);
    const double length = glm::length(n);
    chart.normal = length > 0.0 ? vec3(n / length) : frames_[triangles.front()].normal;
    orthonormalBasis(chart.normal, chart.t, chart.b);
  }

  const geometry::Mesh& mesh_;
  std::span<const std::uint8_t> sides_;
  double cell_area_;
  std::vector<TriangleFrame> frames_;
  Adjacency adjacency_;
  float plane_tolerance_ = 0.0F;
  std::vector<std::uint32_t> small_of_;
  std::vector<std::uint32_t> marks_;
  Charts result_;
};

}  // namespace

Charts makeCharts(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell) {
  return ChartMaker(mesh, sides, cell).make();
}

}  // namespace soffit::transfer
