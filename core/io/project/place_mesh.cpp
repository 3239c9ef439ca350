// SPDX-License-Identifier: MIT
#include "core/io/project/place_mesh.h"

namespace soffit::io {

geometry::Mesh placeMesh(const geometry::Mesh& mesh, const GeometryEntry& entry) {
  geometry::Mesh placed = mesh;
  const dmat3 rotation = rotationXyz(entry.rotate_deg);
  placed.origin = entry.translate + rotation * (entry.scale * mesh.origin);
  const bool turned = rotation != dmat3(1.0);
  for (vec3& p : placed.positions) p = vec3(rotation * (entry.scale * dvec3(p)));
  for (vec3& n : placed.normals) {
    if (turned) n = vec3(glm::normalize(rotation * dvec3(n)));
  }
  return placed;
}

}  // namespace soffit::io
