// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/io/project/project.h"

namespace soffit::io {

/// A model where a project's geometry entry puts it: v_world = translate + Rz Ry Rx scale v.
///
/// mesh  metres, z up (unit and up axis are applied already); its frame's origin is turned and
/// moved in double precision, so that a part far from the world's origin keeps its millimetres.
geometry::Mesh placeMesh(const geometry::Mesh& mesh, const GeometryEntry& entry);

}  // namespace soffit::io
