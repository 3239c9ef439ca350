// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <cstddef>

namespace soffit::geometry {

/// Area of a triangle of the mesh, m^2: |(b - a) x (c - a)| / 2 in single precision, whose
/// rounding is at most a few 2^-24 of the product of the two edges.
inline double areaOf(const Mesh& mesh, std::size_t triangle) {
  const uvec3& t = mesh.triangles[triangle];
  const vec3& a = mesh.positions[t.x];
  return 0.5 * static_cast<double>(
                   glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a)));
}

}  // namespace soffit::geometry
