// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// Rooms of a project, as far as its work planes tell: what lies behind a door is judged against
/// its own light.
namespace soffit::design {

/// Work planes under one ceiling, and points of the free space before and above them.
struct Room {
  std::string name;                 ///< of its work planes, joined by " + "
  std::vector<std::size_t> planes;  ///< indices
  std::vector<vec3> points;         ///< scene-local
};

inline constexpr std::size_t kNoRoom = static_cast<std::size_t>(-1);

/// Groups work planes: two belong to one room when at least a tenth of the lines between points
/// close below the ceiling above them are free. Up there walls go on over doors, while furniture
/// and partitions have ended; an opening that reaches the ceiling joins what it lies between.
///
/// caster  of the scene-local geometry; origin: Mesh::origin. Deterministic.
std::vector<Room> findRooms(const geometry::RayCaster& caster, const dvec3& origin,
                            std::span<const scene::WorkPlane> planes);

/// The room of each point: the one of whose points most are seen from it; kNoRoom where none is.
///
/// positions  scene-local.   normals  unit: what lies behind a point is not seen; one per point.
std::vector<std::size_t> assignRooms(const geometry::RayCaster& caster, std::span<const Room> rooms,
                                     std::span<const dvec3> positions,
                                     std::span<const dvec3> normals);

}  // namespace soffit::design
