// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/panes.h"
#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/light/blockers.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::transfer {

/// The geometry that never moves, made ready: what rays hit, what blocks light, which sides see
/// light. Scene-local frame (world minus Mesh::origin). Immutable.
struct StaticScene {
  std::shared_ptr<const geometry::Mesh> mesh;
  geometry::RayCaster caster;  ///< over all that is not glass
  light::Blockers blockers;    ///< of all that is not glass
  std::vector<vec3> normals;         ///< geometric, per triangle, unit, toward the front
  std::vector<std::uint8_t> sides;   ///< per triangle, transfer::Sides
  float epsilon = 1e-4F;             ///< m; points nearer to a surface are on it
  /// The glass, which dims and mirrors what passes it; null without. It carries no texels.
  std::shared_ptr<const daylight::Panes> panes = nullptr;
  std::vector<light::MaskBlocker> pane_faces = {};  ///< the glass as few convex faces

  [[nodiscard]] bool hitsFront(std::uint32_t triangle, const vec3& direction) const {
    return glm::dot(normals[triangle], direction) < 0.0F;
  }
};

/// inside  points known to lie in rooms (luminaires, sensors, cameras; scene-local): a closed
///         shell that holds one of them is a room and carries light on both sides, as does one
///         that holds other geometry or is all there is. Other closed, consistently wound solids
///         carry light outside only. Sides from which nothing but the void outside the model is
///         seen (the far side of a room's walls) carry none. A solid with glass in its shell can be
///         looked into, so it is none.
/// panes   the mesh's glass, null without.
std::shared_ptr<const StaticScene> makeStaticScene(
    std::shared_ptr<const geometry::Mesh> mesh, std::span<const vec3> inside,
    std::shared_ptr<const daylight::Panes> panes = nullptr);

}  // namespace soffit::transfer
