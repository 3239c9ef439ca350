// SPDX-License-Identifier: MIT
#include "core/prt/chart_growth.h"

#include "core/geometry/weld.h"
#include "core/math/sampling.h"
#include "core/prt/flat_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace soffit::prt {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr float kSmooth = 0.9999F;  ///< cosine between corner normals that count as one

/// Across each edge of each triangle the neighbor that continues it smoothly.
class SmoothNeighbors {
 public:
  SmoothNeighbors(const Surfaces& s, std::span<const std::uint32_t> triangles)
      : surfaces_(s), across_(3 * s.triangleCount(), kNone) {
    const std::vector<std::uint32_t> point = geometry::weldPositions(s.mesh->positions, 0.0F);
    std::vector<Edge> edges;
    for (const std::uint32_t t : triangles) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = point[s.mesh->triangles[t][static_cast<int>(k)]];
        const std::uint32_t b = point[s.mesh->triangles[t][static_cast<int>((k + 1) % 3)]];
        edges.push_back({std::min(a, b), std::max(a, b), t, k, a > b});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
      return std::tie(x.a, x.b, x.triangle, x.k) < std::tie(y.a, y.b, y.triangle, y.k);
    });
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) join(edges[i], edges[i + 1]);
  }
  [[nodiscard]] std::uint32_t across(std::uint32_t triangle, std::uint32_t k) const {
    return across_[3 * std::size_t{triangle} + k];
  }

 private:
  struct Edge {
    std::uint32_t a, b, triangle, k;
    bool reversed;
  };

  [[nodiscard]] const vec3& normal(std::uint32_t triangle, std::uint32_t k) const {
    return surfaces_.corner_normals[3 * std::size_t{triangle} + k % 3];
  }
  /// Corner normal at the edge's end a or b.
  [[nodiscard]] const vec3& normalAt(const Edge& e, bool at_b) const {
    return normal(e.triangle, e.k + (at_b != e.reversed ? 1 : 0));
  }

  void join(const Edge& x, const Edge& y) {
    const geometry::Mesh& m = *surfaces_.mesh;
    if (x.a != y.a || x.b != y.b || x.reversed == y.reversed) return;
    const bool alike =
        (m.material_of.empty() || m.material_of[x.triangle] == m.material_of[y.triangle]) &&
        surfaces_.sides[x.triangle] == surfaces_.sides[y.triangle];
    if (!alike || glm::dot(normalAt(x, false), normalAt(y, false)) < kSmooth ||
        glm::dot(normalAt(x, true), normalAt(y, true)) < kSmooth) {
      return;
    }
    across_[3 * std::size_t{x.triangle} + x.k] = y.triangle;
    across_[3 * std::size_t{y.triangle} + y.k] = x.triangle;
  }

  const Surfaces& surfaces_;
  std::vector<std::uint32_t> across_;
};

/// Axes of a chart's plane: t along the longest edge of its border (the diagonal of a rectangle is
/// longer, but inside).
struct Plane {
  vec3 t{1, 0, 0}, b{0, 1, 0};

  /// inner: (triangle, k) -> whether the triangle goes on into another of them across edge k.
  template <class Inner>
  Plane(const Surfaces& s, std::span<const std::uint32_t> triangles, const Inner& inner) {
    vec3 normal(0.0F);
    for (const std::uint32_t k : triangles) normal += s.areas[k] * s.normals[k];
    normal = glm::normalize(normal);
    vec3 along(0.0F);
    float longest = 0.0F;
    for (const std::uint32_t i : triangles) {
      for (int k = 0; k < 3; ++k) {
        if (inner(i, k)) continue;
        const vec3 e = s.corner(i, (k + 1) % 3) - s.corner(i, k);
        const float score = glm::length(e);
        if (score <= longest * 1.0001F) continue;
        longest = score;
        along = e;
      }
    }
    along -= glm::dot(along, normal) * normal;
    if (glm::dot(along, along) > 0.0F) {
      t = glm::normalize(along);
      b = glm::cross(normal, t);
    } else {
      orthonormalBasis(normal, t, b);
    }
  }
  [[nodiscard]] std::array<vec2, 3> flat(const Surfaces& s, std::uint32_t triangle) const {
    std::array<vec2, 3> c;
    for (int k = 0; k < 3; ++k) {
      const vec3 p = s.corner(triangle, k) - s.corner(triangle, 0);
      const vec3& zero = s.corner(triangle, 0);
      // Doubles for the far corner: lengths of a large model keep their millimetres.
      c[static_cast<std::size_t>(k)] =
          vec2(static_cast<float>(glm::dot(dvec3(zero), dvec3(t))) + glm::dot(p, t),
               static_cast<float>(glm::dot(dvec3(zero), dvec3(b))) + glm::dot(p, b));
    }
    return c;
  }
};

class Growth {
 public:
  Growth(const Surfaces& s, std::span<const std::uint32_t> triangles, const GrowthOptions& options)
      : surfaces_(s),
        options_(options),
        neighbors_(s, triangles),
        taken_(s.triangleCount(), 1),
        marks_(s.triangleCount(), kNone),
        order_(triangles.begin(), triangles.end()) {
    for (const std::uint32_t t : order_) taken_[t] = 0;
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return s.areas[a] > s.areas[b]; });
  }

  std::vector<FlatChart> grow() {
    std::vector<FlatChart> charts;
    for (const std::uint32_t seed : order_) {
      // What a chart leaves behind may begin another at the same seed's neighbors.
      while (taken_[seed] == 0) charts.push_back(flatten(region(seed)));
    }
    return charts;
  }

 private:
  std::vector<std::uint32_t> region(std::uint32_t seed) {
    const auto least = static_cast<float>(std::cos(radians(options_.cone_deg)));
    std::vector<std::uint32_t> found{seed};
    ++round_;
    marks_[seed] = round_;
    for (std::size_t head = 0; head < found.size(); ++head) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = neighbors_.across(found[head], k);
        if (other == kNone || taken_[other] != 0 || marks_[other] == round_) continue;
        if (glm::dot(surfaces_.normals[other], surfaces_.normals[seed]) < least) continue;
        marks_[other] = round_;
        found.push_back(other);
      }
    }
    return found;
  }

  /// Lays the region flat and keeps what does not come to lie on something else of it.
  FlatChart flatten(const std::vector<std::uint32_t>& region) {
    const Plane plane(surfaces_, region, [this](std::uint32_t t, int k) {
      const std::uint32_t other = neighbors_.across(t, static_cast<std::uint32_t>(k));
      return other != kNone && marks_[other] == round_;
    });
    FlatChart all;
    vec2 lo(std::numeric_limits<float>::infinity());
    vec2 hi(-lo);
    for (const std::uint32_t t : region) {
      all.corners.push_back(plane.flat(surfaces_, t));
      for (const vec2& c : all.corners.back()) {
        lo = glm::min(lo, c);
        hi = glm::max(hi, c);
      }
    }
    for (auto& corners : all.corners) {
      for (vec2& c : corners) c -= lo;
    }
    const vec2 size = hi - lo;
    FlatCover cover(size, std::max(static_cast<float>(options_.texel) / 4.0F,
                                   std::max(size.x, size.y) / 512.0F));
    FlatChart chart;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (!cover.claim(all.corners[i]) && i > 0) continue;
      taken_[region[i]] = 1;
      chart.triangles.push_back(region[i]);
      chart.corners.push_back(all.corners[i]);
    }
    moveToZero(chart);
    return chart;
  }

  static void moveToZero(FlatChart& chart) {
    vec2 lo(std::numeric_limits<float>::infinity());
    vec2 hi(-lo);
    for (const auto& corners : chart.corners) {
      for (const vec2& c : corners) {
        lo = glm::min(lo, c);
        hi = glm::max(hi, c);
      }
    }
    for (auto& corners : chart.corners) {
      for (vec2& c : corners) c -= lo;
    }
    chart.size = hi - lo;
  }

  const Surfaces& surfaces_;
  GrowthOptions options_;
  SmoothNeighbors neighbors_;
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint32_t> marks_;
  std::vector<std::uint32_t> order_;
  std::uint32_t round_ = 0;
};

}  // namespace

std::vector<FlatChart> growCharts(const Surfaces& surfaces,
                                  std::span<const std::uint32_t> triangles,
                                  const GrowthOptions& options) {
  return Growth(surfaces, triangles, options).grow();
}

}  // namespace soffit::prt
