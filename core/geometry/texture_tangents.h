// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

namespace soffit::geometry {

/// Metres along a triangle per unit of u and of v, not normalised; false, and nothing to be used,
/// where the mesh's texture coordinates say nothing (it must have them).
bool textureTangents(const Mesh& mesh, const uvec3& triangle, vec3& along_u, vec3& along_v);

}  // namespace soffit::geometry
