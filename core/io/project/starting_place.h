// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/scene/scene.h"

#include <optional>

namespace soffit::io {

/// Where somebody who opens a building for the first time stands.
struct StartingPlace {
  scene::Camera camera;                        ///< world
  std::optional<scene::WorkPlane> work_plane;  ///< 0.8 m above the floor; absent in the open
};

/// Looks for the place inside with the widest view: over a grid of plan positions and all floors
/// with 2 to 12 m of headroom, the one at 1.6 m above the floor from which the level rays all meet
/// walls and reach farthest, none nearer than 0.3 m. The camera looks along the longest of them;
/// the work plane is the rectangle along x and y between the walls around that place (sought above
/// the doors), less 0.5 m or a tenth, in cells of about half a metre.
///
/// A model without such a place gets a camera that sees all of it from outside. The mesh has at
/// least one triangle.
StartingPlace startingPlace(const geometry::Mesh& mesh);

}  // namespace soffit::io
