// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"

#include <vector>

namespace soffit::geometry {

/// A room as somebody who walks through the model finds it. Coordinates are relative to
/// Mesh::origin, in metres.
struct Space {
  float floor = 0.0F;   ///< z
  float height = 0.0F;  ///< clear, above most of its floor
  float area = 0.0F;    ///< m², by cells of the plan
  Box box;              ///< of its cells, floor to ceiling
  vec2 center{0.0F};    ///< where the walls are farthest
  vec2 corner{0.0F};    ///< far from the center, with a free view of it at eye height
  vec2 rectangle_lo{0.0F}, rectangle_hi{0.0F};  ///< the largest along x and y in the plan
};

/// Finds the rooms of a building: cells of its plan (0.15 m, or a 160th of the larger side) with at
/// least 2 m of headroom, joined where nothing stands between them just below the ceiling. Above a
/// door there is wall, so that doors part rooms, open or shut; what furniture covers belongs to its
/// room, what hangs lower than 85 % of its height does not. Only spaces of at least 1.5 m² and 0.8
/// m across count whose walls stop three quarters of the level rays from the center: not the inside
/// of walls, not eaves.
///
/// Sorted by floor, then by area, the largest first. A split level of more than 0.3 m down or 1.2 m
/// up is another space; a beam that comes down lower than
/// that parts rooms as well.
std::vector<Space> findSpaces(const Mesh& mesh, const RayCaster& caster);

}  // namespace soffit::geometry
