// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/math/vec.h"

namespace soffit::geometry {

/// For each triangle over welded points 1 where it should be turned over so that neighbors agree,
/// else 0.
///
/// Exporters, those of building models above all, write the faces of a body with their fronts
/// here inward, there outward. Parts joined by edges of exactly two triangles are made
/// consistent: closed ones with their fronts outward, open ones the way most of their area faces.
/// Parts that are consistent already stay as they are, inward ones too, and so do those that have
/// no consistent winding (Moebius bands). O(n log n).
std::vector<char> findTurned(std::span<const vec3> points, std::span<const uvec3> triangles);

}  // namespace soffit::geometry
