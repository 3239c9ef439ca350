// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/math/vec.h"

namespace soffit::geometry {

/// Cuts a simple polygon into corners.size() - 2 triangles of corner numbers, wound like it.
///
/// The polygon may be concave, slightly warped, and touch itself at corners or along edges (holes
/// tied in by a slit); one that crosses itself gives triangles that cover it somehow.
/// Quadrilaterals are cut along the shorter of their valid diagonals; others by clipping ears
/// (Meisters 1975) in the plane that the polygon's normal (Newell) is closest to, O(n · reflex
/// corners). Beyond 30,000 corners it becomes a fan, which is right for convex polygons only. Fewer
/// than 3 corners: none.
std::vector<uvec3> triangulatePolygon(std::span<const dvec3> corners);

}  // namespace soffit::geometry
