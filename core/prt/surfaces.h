// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/panes.h"
#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/scene/material.h"
#include "core/transfer/charts.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// What transfer is computed on: the surfaces that send and receive light.
namespace soffit::prt {

/// Scene-local frame (world minus Mesh::origin), metres. Immutable.
///
/// Unlike the interactive engine's scene it keeps the sides that see nothing but the outside: with
/// distant light these are the brightest.
struct Surfaces {
  std::shared_ptr<const geometry::Mesh> mesh;
  std::vector<scene::Material> materials;             ///< index = Mesh::material_of
  std::shared_ptr<const daylight::Panes> panes;       ///< the glass, null without
  std::shared_ptr<const geometry::RayCaster> caster;  ///< over all that is not glass
  std::vector<vec3> normals;         ///< per triangle, geometric, unit, front; 0 without area
  std::vector<vec3> corner_normals;  ///< three per triangle, shading, unit, on the front's side
  std::vector<float> areas;          ///< per triangle, m^2
  std::vector<std::uint8_t> sides;   ///< per triangle, transfer::Sides that receive light

  [[nodiscard]] std::size_t triangleCount() const { return sides.size(); }
  [[nodiscard]] bool hitsFront(std::uint32_t triangle, const vec3& direction) const {
    return glm::dot(normals[triangle], direction) < 0.0F;
  }
  [[nodiscard]] bool receives(std::uint32_t triangle, bool front) const {
    return (sides[triangle] & (front ? transfer::kFront : transfer::kBack)) != 0;
  }
  [[nodiscard]] const scene::Material& material(std::uint32_t triangle) const;
  /// A corner's place in the mesh, k in 0..2.
  [[nodiscard]] const vec3& corner(std::uint32_t triangle, int k) const {
    return mesh->positions[mesh->triangles[triangle][k]];
  }
};

/// Closed, consistently wound solids receive on their outside only, or on their inside only when
/// they are rooms: when they hold one of the points `inside` (luminaires, cameras; scene-local) or
/// another part of the geometry. Everything else receives on both sides; glass and triangles
/// without area on none. Corner normals are the mesh's, turned to the front; the face's without.
std::shared_ptr<const Surfaces> makeSurfaces(std::shared_ptr<const geometry::Mesh> mesh,
                                             std::vector<scene::Material> materials,
                                             std::span<const vec3> inside = {});

}  // namespace soffit::prt
