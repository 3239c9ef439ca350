// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soffit::geometry {

/// An indexed triangle mesh in metres, z up, right-handed; a triangle's front is where its
/// vertices run counter-clockwise.
///
/// Vertices are single precision relative to `origin` (world = origin + position), so that a
/// building in survey coordinates keeps its millimetres. `origin` is (0,0,0) for everyday models.
struct Mesh {
  dvec3 origin{0.0};
  std::vector<vec3> positions;
  std::vector<vec3> normals;  ///< shading normals per vertex, unit; empty or one per position
  std::vector<vec2> uvs;      ///< texture coordinates per vertex; empty or one per position
  std::vector<uvec3> triangles;
  std::vector<std::uint32_t> material_of;  ///< per triangle, index into `materials`
  std::vector<std::uint32_t> object_of;    ///< per triangle, index into `objects`
  std::vector<std::string> materials;      ///< names as in the file, unique
  std::vector<std::string> objects;        ///< names of parts as in the file (may repeat)

  [[nodiscard]] std::size_t triangleCount() const { return triangles.size(); }
  [[nodiscard]] Box bounds() const {
    Box box;
    for (const vec3& p : positions) box.add(p);
    return box;
  }
};

}  // namespace soffit::geometry
