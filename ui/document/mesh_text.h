// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <span>
#include <string>

/// Meshes of luminaires that the program makes itself.
namespace soffit::ui {

/// OBJ text of a mesh, metres, z up, positions that read back the same.
std::string objText(const geometry::Mesh& mesh);

/// A flat ring about z that emits downward: its front is -z.
geometry::Mesh ringMesh(float outer, float inner, int columns);

/// Part of a building as a mesh of its own about its middle, its faces moved out by `lift` m so
/// that the building's own do not hide them.
///
/// triangles  indices into `building`.
/// flip       turns all faces round: the side that was pointed at emits.
/// middle     receives the world place of the new mesh's origin.
geometry::Mesh liftedPart(const geometry::Mesh& building, std::span<const std::uint32_t> triangles,
                          bool flip, float lift, dvec3& middle);

/// The triangles that hang together with one over common corners and have its object and material.
std::vector<std::uint32_t> partAround(const geometry::Mesh& building, std::uint32_t triangle);

}  // namespace soffit::ui
