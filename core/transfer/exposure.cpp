// SPDX-License-Identifier: MIT
#include "core/transfer/exposure.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <array>
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

std::array<vec3, kMatterProbes> matterProbes(const vec3& t, const vec3& b, const vec3& n) {
  std::array<vec3, kMatterProbes> directions;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const vec3 d = cosineHemisphere((static_cast<float>(k % 4) + 0.37F) / 4.0F,
                                    (static_cast<float>(k / 4) + 0.59F) / 2.0F);
    directions[k] = d.x * t + d.y * b + d.z * n;
  }
  return directions;
}

bool liesInMatter(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                  const geometry::RayCaster& caster, const vec3& p, const vec3& n) {
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  const vec3 origin = geometry::offsetOrigin(p, n);
  int inside = 0;
  for (const vec3& direction : matterProbes(t, b, n)) {
    const geometry::Hit hit = caster.closest({origin, 0.0F, direction});
    if (hit.valid() && meetsInside(mesh, sides, hit.triangle, direction)) ++inside;
  }
  return inside > kMostInside;
}

SurfacePlace exposedPart(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                         const geometry::RayCaster& caster, const Charts& charts,
                         const Chart& chart, const SurfacePlace& whole, const vec3& n, float gap) {
  constexpr std::uint32_t kMost = 16;
  const Cover own = coverOf(mesh, sides, caster, whole.point, n, gap);
  const auto inMatter = [&](const vec3& p) { return liesInMatter(mesh, sides, caster, p, n); };
  std::vector<SurfacePlace> open;
  double all = 0.0;
  double exposed = 0.0;
  dvec3 center(0.0);
  const std::uint32_t step = std::max(1U, chart.triangle_count / kMost);
  // Few long triangles are seen at more than their middle: part of a rim may run through matter.
  constexpr std::array<vec3, 4> kPlaces{vec3(1.0F / 3.0F), vec3(0.7F, 0.15F, 0.15F),
                                        vec3(0.15F, 0.7F, 0.15F), vec3(0.15F, 0.15F, 0.7F)};
  const std::span<const vec3> shares =
      std::span(kPlaces).first(chart.triangle_count <= kMost / 2 ? kPlaces.size() : 1);
  for (std::uint32_t k = 0; k < chart.triangle_count; k += step) {
    SurfacePlace place;
    place.triangle = charts.triangles[chart.first_triangle + k];
    const uvec3& i = mesh.triangles[place.triangle];
    const vec3& a = mesh.positions[i.x];
    const vec3& b = mesh.positions[i.y];
    const vec3& c = mesh.positions[i.z];
    const double area = 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
    place.area = area / static_cast<double>(shares.size());
    for (const vec3& share : shares) {
      place.point = share.x * a + share.y * b + share.z * c;
      all += place.area;
      const Cover cover = coverOf(mesh, sides, caster, place.point, n, gap);
      if (cover == Cover::matter || (cover == Cover::gap && own == Cover::none)) continue;
      exposed += place.area;
      center += place.area * dvec3(place.point);
      open.push_back(place);
    }
  }
  SurfacePlace out = whole;
  if (open.empty() || exposed <= 0.0) {
    // Too small for the samples: the point decides.
    if (own == Cover::matter) out.area = 0.0;
    return out;
  }
  if (exposed >= all && own != Cover::matter && !inMatter(whole.point)) return out;
  center /= exposed;
  out.area = whole.area * exposed / all;
  const auto fromCenter = [&](const SurfacePlace& s) {
    const dvec3 d = dvec3(s.point) - center;
    return glm::dot(d, d);
  };
  std::stable_sort(open.begin(), open.end(), [&](const SurfacePlace& x, const SurfacePlace& y) {
    return fromCenter(x) < fromCenter(y);
  });
  auto best = std::find_if_not(open.begin(), open.end(),
                               [&](const SurfacePlace& s) { return inMatter(s.point); });
  if (best == open.end()) best = open.begin();
  out.point = best->point;
  out.triangle = best->triangle;
  return out;
}

}  // namespace soffit::transfer
