// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/spaces.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace soffit::io {

/// A camera and a work plane in each room of an imported building, all of one name per room.
struct RoomPlaces {
  std::vector<scene::Camera> cameras;         ///< from a corner, 1.6 m above the floor
  std::vector<scene::WorkPlane> work_planes;  ///< 0.8 m above the floor, inside the walls
};

/// The work plane is the largest rectangle along x and y inside the room less 0.5 m (or a tenth of
/// it, if that is less) along the walls, in cells of about half a metre. Numbers are rounded to
/// centimetres. `origin` is Mesh::origin; names[i] belongs to spaces[i].
RoomPlaces roomPlaces(const std::vector<geometry::Space>& spaces,
                      const std::vector<std::string>& names, const dvec3& origin);

/// "Room 1", "Room 2", ... in the order of findSpaces().
std::vector<std::string> roomNames(std::size_t count);

}  // namespace soffit::io
