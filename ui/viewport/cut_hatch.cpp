// SPDX-License-Identifier: MIT
#include "ui/viewport/cut_hatch.h"

#include "core/geometry/components.h"
#include "core/transfer/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace soffit::ui {
namespace {

/// A piece of an outline in the plane, its body to the left.
using Piece = std::array<dvec2, 2>;

/// Where a triangle meets the plane: from the edge that rises through it to the one that falls, so
/// that pieces of one body follow one another.
std::optional<Piece> cut(const geometry::Mesh& mesh, const uvec3& t, int axis, double place) {
  const auto at = static_cast<float>(place);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Piece piece;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    const vec3& a = mesh.positions[t[k]];
    const vec3& b = mesh.positions[t[(k + 1) % 3]];
    const bool rises = a[axis] < at;
    if (rises == (b[axis] < at)) continue;
    // From the lower end in either triangle, for the same rounding.
    const dvec3 low(rises ? a : b);
    const dvec3 high(rises ? b : a);
    const double way = (place - low[axis]) / (high[axis] - low[axis]);
    const dvec3 p = low + way * (high - low);
    piece[rises ? 0 : 1] = dvec2(p[u], p[v]);
    found = true;
  }
  return found ? std::optional(piece) : std::nullopt;
}

/// Where outlines cross a line of the hatching: how far along it, and which way.
using Crossings = std::vector<std::pair<double, int>>;

void cross(const Piece& piece, double step, std::map<long, Crossings>& lines) {
  const double from = piece[0].x + piece[0].y;
  const double to = piece[1].x + piece[1].y;
  const auto first = static_cast<long>(std::floor(std::min(from, to) / step)) + 1;
  const auto last = static_cast<long>(std::floor(std::max(from, to) / step));
  for (long i = first; i <= last; ++i) {
    const double level = static_cast<double>(i) * step;
    const dvec2 p = piece[0] + (level - from) / (to - from) * (piece[1] - piece[0]);
    lines[i].emplace_back(p.x - p.y, from < to ? 1 : -1);
  }
}

}  // namespace

std::vector<std::uint8_t> solidTriangles(const geometry::Mesh& mesh,
                                         std::span<const std::uint8_t> sides) {
  std::vector<std::uint8_t> solid(mesh.triangles.size(), 0);
  if (sides.size() != mesh.triangles.size()) return solid;
  for (const geometry::Component& body : geometry::findComponents(mesh).list) {
    const bool lit_inside = std::ranges::any_of(
        body.triangles, [&](std::uint32_t t) { return (sides[t] & transfer::kBack) != 0; });
    if (!body.solid() || !body.outward() || lit_inside) continue;
    for (const std::uint32_t t : body.triangles) solid[t] = 1;
  }
  return solid;
}

std::vector<vec3> sectionHatch(const geometry::Mesh& mesh, std::span<const std::uint8_t> solid,
                               int axis, double place, double spacing) {
  std::vector<vec3> ends;
  if (solid.size() != mesh.triangles.size()) return ends;
  const double step = std::sqrt(2.0) * spacing;
  std::map<long, Crossings> lines;
  for (std::size_t t = 0; t < solid.size(); ++t) {
    if (solid[t] == 0) continue;
    if (const auto piece = cut(mesh, mesh.triangles[t], axis, place)) cross(*piece, step, lines);
  }
  const auto add = [&](double level, double along) {
    vec3 p(0.0F);
    p[axis] = static_cast<float>(place);
    p[(axis + 1) % 3] = static_cast<float>(0.5 * (level + along));
    p[(axis + 2) % 3] = static_cast<float>(0.5 * (level - along));
    ends.push_back(p);
  };
  for (auto& [number, crossings] : lines) {
    std::ranges::sort(crossings);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].second;
      if (winding == 0 || crossings[i].first == crossings[i + 1].first) continue;
      add(static_cast<double>(number) * step, crossings[i].first);
      add(static_cast<double>(number) * step, crossings[i + 1].first);
    }
  }
  return ends;
}

}  // namespace soffit::ui
