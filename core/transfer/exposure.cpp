// SPDX-License-Identifier: MIT
#include "core/transfer/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"
#include "core/math/sampling.h"

namespace soffit::transfer {
namespace {

constexpr int kSide = 4;  // samples per cell and axis

/// A triangle in the plane of its chart.
struct FlatTriangle {
  std::array<vec2, 3> corner;
  vec2 lo, hi;
  std::uint32_t triangle;

  [[nodiscard]] bool contains(const vec2& p) const {
    if (p.x < lo.x || p.y < lo.y || p.x > hi.x || p.y > hi.y) return false;
    bool left = true;
    bool right = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const vec2 e = corner[(k + 1) % 3] - corner[k];
      const vec2 d = p - corner[k];
      const float side = e.x * d.y - e.y * d.x;
      left = left && side >= 0.0F;
      right = right && side <= 0.0F;
    }
    return left || right;
  }
};

struct Sample {
  vec3 point{0.0F};
  std::uint32_t triangle = 0;
  float weight = 1.0F;
};

class Exposure {
 public:
  Exposure(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
           const geometry::RayCaster& caster, const Texels& texels, const DraftTexels& draft)
      : mesh_(mesh), sides_(sides), caster_(caster), texels_(texels), draft_(draft) {}

  void chart(std::size_t index) const {
    const Chart& chart = texels_.charts.charts[index];
    const Texels::Grid& grid = texels_.grids[index];
    std::vector<FlatTriangle> flat;
    if (chart.planar) flat = flatten(chart);
    const std::size_t per_side =
        static_cast<std::size_t>(grid.nu) * static_cast<std::size_t>(grid.nv);
    std::size_t base = grid.first;
    std::vector<Sample> samples;
    for (const Sides side : {kFront, kBack}) {
      if ((chart.sides & side) == 0) continue;
      if (!chart.planar) {
        curvedSamples(chart, samples);
        reduce(texels_.cells[base], samples);
        ++base;
        continue;
      }
      for (std::size_t i = 0; i < per_side; ++i) {
        const std::uint32_t texel = texels_.cells[base + i];
        if (texel == kNoTexel || cellOf(chart, grid, draft_.position[texel]) != i) continue;
        cellSamples(chart, grid, flat, i, samples);
        reduce(texel, samples);
      }
      base += per_side;
    }
  }

 private:
  [[nodiscard]] std::vector<FlatTriangle> flatten(const Chart& chart) const {
    std::vector<FlatTriangle> out;
    for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
      FlatTriangle f;
      f.triangle = texels_.charts.triangles[chart.first_triangle + k];
      const uvec3& t = mesh_.triangles[f.triangle];
      for (int c = 0; c < 3; ++c) {
        const vec3 d = mesh_.positions[t[c]] - chart.origin;
        f.corner[static_cast<std::size_t>(c)] = vec2(glm::dot(d, chart.t), glm::dot(d, chart.b));
      }
      f.lo = glm::min(glm::min(f.corner[0], f.corner[1]), f.corner[2]);
      f.hi = glm::max(glm::max(f.corner[0], f.corner[1]), f.corner[2]);
      out.push_back(f);
    }
    return out;
  }

  static std::size_t cellOf(const Chart& chart, const Texels::Grid& grid, const vec3& p) {
    const vec3 d = p - chart.origin;
    const int i = std::clamp(static_cast<int>(glm::dot(d, chart.t) / grid.cell.x), 0, grid.nu - 1);
    const int j = std::clamp(static_cast<int>(glm::dot(d, chart.b) / grid.cell.y), 0, grid.nv - 1);
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nu) +
           static_cast<std::size_t>(i);
  }

  static void cellSamples(const Chart& chart, const Texels::Grid& grid,
                          std::span<const FlatTriangle> flat, std::size_t cell,
                          std::vector<Sample>& out) {
    out.clear();
    const auto nu = static_cast<std::size_t>(grid.nu);
    const vec2 corner =
        vec2(static_cast<float>(cell % nu), static_cast<float>(cell / nu)) * grid.cell;
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const vec2 share((static_cast<float>(i) + 0.5F) / kSide,
                         (static_cast<float>(j) + 0.5F) / kSide);
        const vec2 p = corner + share * grid.cell;
        const auto on = std::find_if(flat.begin(), flat.end(),
                                     [&](const FlatTriangle& f) { return f.contains(p); });
        if (on != flat.end())
          out.push_back({chart.origin + p.x * chart.t + p.y * chart.b, on->triangle, 1.0F});
      }
    }
  }

  /// Centres of (at most 16 of) its triangles.
  void curvedSamples(const Chart& chart, std::vector<Sample>& out) const {
    out.clear();
    const std::uint32_t step = std::max(1U, chart.triangle_count / (kSide * kSide));
    for (std::uint32_t k = 0; k < chart.triangle_count; k += step) {
      const std::uint32_t index = texels_.charts.triangles[chart.first_triangle + k];
      const uvec3& t = mesh_.triangles[index];
      const vec3& a = mesh_.positions[t.x];
      const vec3& b = mesh_.positions[t.y];
      const vec3& c = mesh_.positions[t.z];
      out.push_back({(a + b + c) / 3.0F, index, glm::length(glm::cross(b - a, c - a))});
    }
  }

  void reduce(std::uint32_t texel, std::span<const Sample> samples) const {
    if (texel == kNoTexel) return;
    const vec3& n = draft_.normal[texel];
    const auto gap = static_cast<float>(Texels::kGapShare * texels_.cell);
    const Cover own = coverOf(mesh_, sides_, caster_, draft_.position[texel], n, gap);
    const bool covered = own == Cover::matter;
    double whole = 0.0;
    double exposed = 0.0;
    dvec3 center(0.0);
    std::vector<const Sample*> open;
    for (const Sample& s : samples) {
      whole += s.weight;
      const Cover cover = coverOf(mesh_, sides_, caster_, s.point, n, gap);
      // A texel in the open leaves out what reaches into a gap: the room's light ends there.
      if (cover == Cover::matter || (cover == Cover::gap && own == Cover::none)) continue;
      exposed += s.weight;
      center += static_cast<double>(s.weight) * dvec3(s.point);
      open.push_back(&s);
    }
    if (open.empty()) {
      // Too narrow for the samples: the point decides.
      if (covered) draft_.area[texel] = 0.0F;
      return;
    }
    if (open.size() == samples.size() && !covered) return;
    center /= exposed;
    draft_.area[texel] *= static_cast<float>(exposed / whole);
    double best = std::numeric_limits<double>::max();
    for (const Sample* s : open) {
      const dvec3 d = dvec3(s->point) - center;
      if (glm::dot(d, d) >= best) continue;
      best = glm::dot(d, d);
      draft_.position[texel] = s->point;
      draft_.triangle[texel] = s->triangle;
    }
  }

  const geometry::Mesh& mesh_;
  std::span<const std::uint8_t> sides_;
  const geometry::RayCaster& caster_;
  const Texels& texels_;
  const DraftTexels& draft_;
};

}  // namespace

Cover coverOf(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
              const geometry::RayCaster& caster, const vec3& p, const vec3& n, float gap) {
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  // Tilted a little: straight up from a grid point often meets the edge of two triangles.
  const vec3 direction = glm::normalize(n + 0.013F * t + 0.007F * b);
  const geometry::Hit hit = caster.closest({geometry::offsetOrigin(p, n), 0.0F, direction});
  if (!hit.valid()) return Cover::none;
  if (sides[hit.triangle] != kBothSides) {
    const uvec3& c = mesh.triangles[hit.triangle];
    const vec3& a = mesh.positions[c.x];
    const vec3 normal = glm::cross(mesh.positions[c.y] - a, mesh.positions[c.z] - a);
    const Sides met = glm::dot(normal, direction) < 0.0F ? kFront : kBack;
    if ((sides[hit.triangle] & met) == 0) return Cover::matter;
  }
  return hit.t < gap ? Cover::gap : Cover::none;
}

void measureExposure(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                     const geometry::RayCaster& caster, const Texels& texels,
                     const DraftTexels& draft) {
  const Exposure exposure(mesh, sides, caster, texels, draft);
  parallelFor(texels.charts.charts.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) exposure.chart(i);
  });
}

}  // namespace soffit::transfer
