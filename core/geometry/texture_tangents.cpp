// SPDX-License-Identifier: MIT
#include "core/geometry/texture_tangents.h"

#include <cmath>

namespace soffit::geometry {

bool textureTangents(const Mesh& mesh, const uvec3& triangle, vec3& along_u, vec3& along_v) {
  const vec3 e1 = mesh.positions[triangle.y] - mesh.positions[triangle.x];
  const vec3 e2 = mesh.positions[triangle.z] - mesh.positions[triangle.x];
  const vec2 d1 = mesh.uvs[triangle.y] - mesh.uvs[triangle.x];
  const vec2 d2 = mesh.uvs[triangle.z] - mesh.uvs[triangle.x];
  const float det = d1.x * d2.y - d1.y * d2.x;
  if (!(std::abs(det) > 0.0F) || !std::isfinite(det)) return false;
  along_u = (d2.y * e1 - d1.y * e2) / det;
  along_v = (d1.x * e2 - d2.x * e1) / det;
  return glm::length(along_u) > 0.0F && glm::length(along_v) > 0.0F;
}

}  // namespace soffit::geometry
