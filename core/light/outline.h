// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/math/vec.h"

#include <vector>

/// Plane polygons as luminaire outlines.
namespace soffit::light {

/// A simple polygon made ready: counter-clockwise in its own x, y plane, with a triangulation.
struct Outline {
  std::vector<dvec2> corners;    ///< counter-clockwise, no repeated neighbours
  std::vector<uvec3> triangles;  ///< into `corners`, counter-clockwise, covering it once
  double area = 0.0;             ///< in the square of the corners' unit
};

/// Cleans, orients and triangulates (ear clipping, O(n^2) to O(n^3)) a polygon of any winding; a
/// repeated first corner at the end is dropped. Outlines that touch themselves (a hole joined by
/// a slit of zero width) are legal.
///
/// Errors (place is left empty): non-finite corners, fewer than three different corners, no
/// area, edges that cross.
Result<Outline> makeOutline(const std::vector<dvec2>& polygon);

}  // namespace soffit::light
