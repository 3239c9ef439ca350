// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec.h"

/// Edges of triangles over welded points, as lists of the triangles that meet there.
namespace soffit::geometry {

/// One side of a triangle. lo < hi are points.
struct EdgeSide {
  std::uint32_t lo;
  std::uint32_t hi;
  std::uint32_t triangle;
  std::uint32_t apex;  ///< the triangle's third point
  bool forward;        ///< the triangle runs from lo to hi
};

/// All sides of all triangles, sorted by (lo, hi, triangle), so that an edge's sides are neighbors.
/// Triangles with two equal corners have no sides.
std::vector<EdgeSide> sortedEdgeSides(std::span<const uvec3> triangles);

/// Calls visit(sides) for every edge, sides being a span of one or more EdgeSide.
template <class Visit>
void forEachEdge(std::span<const EdgeSide> sorted, const Visit& visit) {
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t last = first + 1;
    while (last < sorted.size() && sorted[last].lo == sorted[first].lo &&
           sorted[last].hi == sorted[first].hi) {
      ++last;
    }
    visit(sorted.subspan(first, last - first));
    first = last;
  }
}

}  // namespace soffit::geometry
