// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::ui {

/// Per triangle, whether it belongs to a body that a cut shows filled: a closed, consistently wound
/// component with its fronts outward that carries no light inside. A room is none, whichever way
/// it is wound.
/// sides: transfer::StaticScene::sides.
std::vector<std::uint8_t> solidTriangles(const geometry::Mesh& mesh,
                                         std::span<const std::uint8_t> sides);

/// The hatching of what a plane across a world axis (0..2) cuts of those bodies: lines at 45
/// degrees, two ends in a row, scene-local. Bodies that lie in one another are hatched as one: a
/// point is filled where the winding number of the outlines about it is not 0.
/// place: on the axis, scene-local. spacing: of the lines, m, > 0.
std::vector<vec3> sectionHatch(const geometry::Mesh& mesh, std::span<const std::uint8_t> solid,
                               int axis, double place, double spacing);

}  // namespace soffit::ui
