// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace soffit::geometry {

/// Triangles over welded points, as normals are made from them.
struct WeldedTriangles {
  std::span<const vec3> points;              ///< metres
  std::span<const uvec3> triangles;          ///< none without area
  std::span<const std::uint32_t> object_of;  ///< per triangle
};

/// A unit normal for every corner (3 per triangle): the sum over the triangles about the point
/// that belong to the same object and whose face turns by at most crease_deg from the corner's
/// own, each weighted by its angle at the point (Thuermer & Wuethrich 1998). Corners that average
/// the same triangles get bit-equal normals.
std::vector<vec3> cornerNormals(const WeldedTriangles& mesh, double crease_deg);

}  // namespace soffit::geometry
