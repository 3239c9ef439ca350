// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/math/vec.h"

namespace soffit::geometry {

/// For each triangle over welded points 1 where it repeats an earlier one, else 0: the same three
/// points in any order. Of a back-to-back pair (opposite windings) the later is spared if both
/// belong to solids of their own, as the touching walls of two cabinets do; dropping one would
/// open a solid. Points that no triangle uses may be NaN. O(n log n).
std::vector<char> markDuplicates(std::span<const vec3> points, std::span<const uvec3> triangles);

}  // namespace soffit::geometry
