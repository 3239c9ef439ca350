// SPDX-License-Identifier: MIT
#include "core/transfer/exposure.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace soffit::transfer {

bool meetsInside(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                 std::uint32_t triangle, const vec3& direction) {
  if (sides[triangle] == kBothSides) return false;
  const uvec3& c = mesh.triangles[triangle];
  const vec3& a = mesh.positions[c.x];
  const vec3 normal = glm::cross(mesh.positions[c.y] - a, mesh.positions[c.z] - a);
  const Sides met = glm::dot(normal, direction) < 0.0F ? kFront : kBack;
  return (sides[triangle] & met) == 0;
}

Cover coverOf(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
              const geometry::RayCaster& caster, const vec3& p, const vec3& n, float gap) {
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  // Tilted a little: straight up from a grid point often meets the edge of two triangles.
  const vec3 direction = glm::normalize(n + 0.013F * t + 0.007F * b);
  const geometry::Hit hit = caster.closest({geometry::offsetOrigin(p, n), 0.0F, direction});
  if (!hit.valid()) return Cover::none;
  if (meetsInside(mesh, sides, hit.triangle, direction)) return Cover::matter;
  return hit.t < gap ? Cover::gap : Cover::none;
}

SurfacePlace exposedPart(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                         const geometry::RayCaster& caster, const Charts& charts,
                         const Chart& chart, const SurfacePlace& whole, const vec3& n, float gap) {
  constexpr std::uint32_t kMost = 16;
  const Cover own = coverOf(mesh, sides, caster, whole.point, n, gap);
  std::vector<SurfacePlace> open;
  double all = 0.0;
  double exposed = 0.0;
  dvec3 center(0.0);
  const std::uint32_t step = std::max(1U, chart.triangle_count / kMost);
  for (std::uint32_t k = 0; k < chart.triangle_count; k += step) {
    SurfacePlace place;
    place.triangle = charts.triangles[chart.first_triangle + k];
    const uvec3& i = mesh.triangles[place.triangle];
    const vec3& a = mesh.positions[i.x];
    const vec3& b = mesh.positions[i.y];
    const vec3& c = mesh.positions[i.z];
    place.point = (a + b + c) / 3.0F;
    place.area = 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
    all += place.area;
    const Cover cover = coverOf(mesh, sides, caster, place.point, n, gap);
    if (cover == Cover::matter || (cover == Cover::gap && own == Cover::none)) continue;
    exposed += place.area;
    center += place.area * dvec3(place.point);
    open.push_back(place);
  }
  SurfacePlace out = whole;
  if (open.empty() || exposed <= 0.0) {
    // Too small for the samples: the point decides.
    if (own == Cover::matter) out.area = 0.0;
    return out;
  }
  if (exposed >= all && own != Cover::matter) return out;
  center /= exposed;
  out.area = whole.area * exposed / all;
  double best = std::numeric_limits<double>::max();
  for (const SurfacePlace& s : open) {
    const dvec3 d = dvec3(s.point) - center;
    if (glm::dot(d, d) >= best) continue;
    best = glm::dot(d, d);
    out.point = s.point;
    out.triangle = s.triangle;
  }
  return out;
}

}  // namespace soffit::transfer
