// SPDX-License-Identifier: MIT
#include "core/light/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace soffit::light {
namespace {

/// Twice the signed area of a triangle; positive when counter-clockwise.
double cross(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double signedArea(const std::vector<dvec2>& p) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += cross(p[0], p[i], p[i + 1]);
  return 0.5 * sum;
}

/// Edges that meet in a common end or touch do not cross.
bool properlyCross(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
  return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
}

bool selfCrossing(const std::vector<dvec2>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (properlyCross(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n])) return true;
    }
  }
  return false;
}

std::vector<dvec2> withoutRepeats(const std::vector<dvec2>& polygon) {
  std::vector<dvec2> out;
  for (const dvec2& p : polygon) {
    if (out.empty() || out.back() != p) out.push_back(p);
  }
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

/// Whether no other corner of the remaining ring lies in the triangle a, b, c. Corners that
/// coincide with one of its own (a slit) do not count.
bool isEar(const std::vector<dvec2>& p, const std::vector<std::uint32_t>& ring, const dvec2& a,
           const dvec2& b, const dvec2& c) {
  return std::none_of(ring.begin(), ring.end(), [&](std::uint32_t index) {
    const dvec2& q = p[index];
    if (q == a || q == b || q == c) return false;
    return cross(a, b, q) >= 0.0 && cross(b, c, q) >= 0.0 && cross(c, a, q) >= 0.0;
  });
}

std::vector<uvec3> clipEars(const std::vector<dvec2>& p) {
  std::vector<std::uint32_t> ring(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) ring[i] = static_cast<std::uint32_t>(i);
  std::vector<uvec3> triangles;
  while (ring.size() >= 3) {
    const std::size_t n = ring.size();
    std::size_t clipped = n;
    for (std::size_t i = 0; i < n && clipped == n; ++i) {
      const uvec3 t(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
      const double twice_area = cross(p[t.x], p[t.y], p[t.z]);
      if (twice_area == 0.0) clipped = i;  // a corner on a straight edge spans nothing
      if (twice_area > 0.0 && isEar(p, ring, p[t.x], p[t.y], p[t.z])) {
        triangles.push_back(t);
        clipped = i;
      }
    }
    if (clipped == n) break;  // not simple: the caller finds area missing
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(clipped));
  }
  return triangles;
}

}  // namespace

Result<Outline> makeOutline(const std::vector<dvec2>& polygon) {
  for (const dvec2& p : polygon) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      return Error{"", "a corner of the polygon is not a finite number", "Correct the corner"};
    }
  }
  Outline outline{.corners = withoutRepeats(polygon), .triangles = {}, .area = 0.0};
  std::vector<dvec2>& p = outline.corners;
  if (p.size() < 3) {
    return Error{"", "expected a polygon of at least 3 different corners",
                 "Add corners, or use another shape"};
  }
  if (selfCrossing(p)) {
    return Error{"", "edges of the polygon cross each other",
                 "Reorder its corners around the outline"};
  }
  const double area = signedArea(p);
  if (!(std::abs(area) > 0.0)) {
    return Error{"", "the polygon has no area", "Move its corners off a single line"};
  }
  if (area < 0.0) std::reverse(p.begin(), p.end());
  outline.area = std::abs(area);
  outline.triangles = clipEars(p);
  double covered = 0.0;
  for (const uvec3& t : outline.triangles) covered += 0.5 * cross(p[t.x], p[t.y], p[t.z]);
  // Round-off of n terms; anything beyond means overlapping edges that no triangulation covers.
  if (std::abs(covered - outline.area) > 1e-9 * outline.area) {
    return Error{"", "the polygon runs over itself", "Reorder its corners around the outline"};
  }
  return outline;
}

}  // namespace soffit::light
