// SPDX-License-Identifier: MIT
#include "core/geometry/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/geometry/edge_sides.h"
#include "core/geometry/weld.h"

namespace soffit::geometry {
namespace {

struct DisjointSets {
  std::vector<std::uint32_t> parent;

  explicit DisjointSets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent[std::max(a, b)] = std::min(a, b);  // the root is the first triangle
  }
};

// A side with the angle of its triangle about the edge, counter-clockwise seen from hi.
struct Spoke {
  double angle;
  const EdgeSide* side;
  // Fronts outward, a triangle running lo to hi has its solid on the clockwise side: going
  // counter-clockwise the solid ends there.
  [[nodiscard]] bool ends() const { return side->forward; }
};

std::vector<Spoke> spokesAround(const Mesh& mesh, std::span<const EdgeSide> sides) {
  const dvec3 lo(mesh.positions[sides[0].lo]);
  const dvec3 axis = glm::normalize(dvec3(mesh.positions[sides[0].hi]) - lo);
  const auto away = [&](const EdgeSide& side) {
    const dvec3 w = dvec3(mesh.positions[side.apex]) - lo;
    return w - glm::dot(w, axis) * axis;
  };
  const dvec3 x = away(sides[0]);
  const dvec3 y = glm::cross(axis, x);
  std::vector<Spoke> spokes;
  spokes.reserve(sides.size());
  for (const EdgeSide& side : sides) {
    const dvec3 w = away(side);
    spokes.push_back({std::atan2(glm::dot(w, y), glm::dot(w, x)), &side});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.side->triangle < b.side->triangle;
  });
  return spokes;
}

// Spokes in counter-clockwise order, started after the widest gap, so that no group of coincident
// triangles straddles the start; inside such a group solids end before others begin, which leaves
// two solids in contact apart.
std::vector<Spoke> orderedSpokes(const Mesh& mesh, std::span<const EdgeSide> sides) {
  constexpr double kCoincident = 1e-4;  // radians: far above rounding, far below a modeled angle
  std::vector<Spoke> spokes = spokesAround(mesh, sides);
  std::size_t start = 0;
  double widest = spokes.front().angle + 2.0 * kPi - spokes.back().angle;
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    const double gap = spokes[i].angle - spokes[i - 1].angle;
    if (gap > widest) {
      widest = gap;
      start = i;
    }
  }
  for (std::size_t i = 0; i < start; ++i) spokes[i].angle += 2.0 * kPi;
  std::rotate(spokes.begin(), spokes.begin() + static_cast<std::ptrdiff_t>(start), spokes.end());
  for (auto first = spokes.begin(); first != spokes.end();) {
    auto last = first + 1;
    while (last != spokes.end() && last->angle - (last - 1)->angle < kCoincident) ++last;
    std::stable_partition(first, last, [](const Spoke& s) { return s.ends(); });
    first = last;
  }
  return spokes;
}

// Joins what meets at one edge and marks triangles whose side stays without a partner.
void joinEdge(const Mesh& mesh, std::span<const EdgeSide> sides, DisjointSets& sets,
              std::vector<char>& open, std::vector<char>& twisted) {
  if (sides.size() == 1) {
    open[sides[0].triangle] = 1;
    return;
  }
  if (sides.size() == 2) {
    sets.join(sides[0].triangle, sides[1].triangle);
    if (sides[0].forward == sides[1].forward) twisted[sides[0].triangle] = 1;
    return;
  }
  const std::vector<Spoke> spokes = orderedSpokes(mesh, sides);
  std::vector<char> paired(spokes.size(), 0);
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const std::size_t next = (i + 1) % spokes.size();
    if (spokes[i].ends() || !spokes[next].ends()) continue;
    sets.join(spokes[i].side->triangle, spokes[next].side->triangle);
    paired[i] = paired[next] = 1;
  }
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (paired[i] == 0) open[spokes[i].side->triangle] = 1;
  }
}

Components collect(const Mesh& mesh, DisjointSets& sets) {
  constexpr std::uint32_t kUnnumbered = 0xffffffffU;
  Components out;
  std::vector<std::uint32_t> number(mesh.triangles.size(), kUnnumbered);
  out.component_of.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = sets.find(t);
    if (number[root] == kUnnumbered) {
      number[root] = static_cast<std::uint32_t>(out.list.size());
      out.list.emplace_back();
    }
    out.component_of[t] = number[root];
    Component& component = out.list[number[root]];
    component.triangles.push_back(t);
    for (int k = 0; k < 3; ++k) component.bounds.add(mesh.positions[mesh.triangles[t][k]]);
  }
  return out;
}

// Divergence theorem: a sixth of the triple products, about the middle for accuracy.
double signedVolume(const Mesh& mesh, const Component& component) {
  const dvec3 middle(component.bounds.center());
  double sum = 0.0;
  for (const std::uint32_t t : component.triangles) {
    const uvec3 v = mesh.triangles[t];
    const dvec3 a = dvec3(mesh.positions[v.x]) - middle;
    const dvec3 b = dvec3(mesh.positions[v.y]) - middle;
    const dvec3 c = dvec3(mesh.positions[v.z]) - middle;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

// Solid angle of a triangle seen from the point that its corners are relative to, signed:
// positive when its back is seen (the point is behind it, as inside a solid).
double solidAngle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double numerator = glm::dot(a, glm::cross(b, c));
  const double denominator =
      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

}  // namespace

Components findComponents(const Mesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  std::vector<std::uint32_t> point_of = weldPositions(mesh.positions, weldTolerance(mesh.bounds()));
  std::vector<uvec3> welded(n);
  std::vector<char> open(n, 0);
  std::vector<char> twisted(n, 0);
  for (std::size_t t = 0; t < n; ++t) {
    const uvec3 v = mesh.triangles[t];
    welded[t] = {point_of[v.x], point_of[v.y], point_of[v.z]};
    const uvec3 p = welded[t];
    if (p.x == p.y || p.y == p.z || p.z == p.x) open[t] = 1;
  }
  DisjointSets sets(n);
  const std::vector<EdgeSide> sides = sortedEdgeSides(welded);
  forEachEdge(sides,
              [&](std::span<const EdgeSide> edge) { joinEdge(mesh, edge, sets, open, twisted); });
  Components out = collect(mesh, sets);
  out.point_of = std::move(point_of);
  for (Component& component : out.list) {
    const auto none = [&](const std::vector<char>& mark) {
      return std::none_of(component.triangles.begin(), component.triangles.end(),
                          [&](std::uint32_t t) { return mark[t] != 0; });
    };
    component.closed = none(open);
    component.consistent = none(twisted);
    component.signed_volume = signedVolume(mesh, component);
  }
  return out;
}

bool contains(const Mesh& mesh, const Component& component, const vec3& point) {
  if (!component.bounds.contains(point)) return false;
  const dvec3 p(point);
  double sum = 0.0;
  for (const std::uint32_t t : component.triangles) {
    const uvec3 v = mesh.triangles[t];
    sum += solidAngle(dvec3(mesh.positions[v.x]) - p, dvec3(mesh.positions[v.y]) - p,
                      dvec3(mesh.positions[v.z]) - p);
  }
  return std::abs(sum) > 2.0 * kPi;  // half of the full sphere
}

}  // namespace soffit::geometry
