// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace soffit::design {

/// A line of equal value over a grid.
struct Contour {
  std::vector<dvec2> points;  ///< in steps of the grid: (0, 0) is the first point, x along i
  bool closed = false;        ///< the last point joins the first
};

/// Lines on which a function takes a level, from its values at the points of a regular grid, by
/// marching squares: the function is linear along the edges between points.
///
/// values  nu x nv, i fastest, finite.   level  any.
///
/// A point is above when its value >= level, so no line runs through a point exactly and every
/// line is closed or ends at the border. A saddle, where the two diagonals of a cell lie on
/// different sides, is decided by the bilinear function inside the cell: its value at the saddle
/// point, (ac - bd) / (a + c - b - d) with corners a b c d in order, says which diagonal stays
/// connected (the asymptotic decider; Nielson & Hamann 1991). Lines so keep the topology of
/// bilinear interpolation and cross nowhere. Truncation: O(h^2) in place for smooth functions.
std::vector<Contour> contoursAt(std::span<const double> values, int nu, int nv, double level);

}  // namespace soffit::design
