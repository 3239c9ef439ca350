// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/transfer/charts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soffit::transfer {

/// Whether a ray in this direction met a side that carries no light: the inside of a solid.
bool meetsInside(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                 std::uint32_t triangle, const vec3& direction);

/// What stands over a point of a surface, by a ray along its normal.
enum class Cover : std::uint8_t {
  none,
  gap,    ///< a surface, nearer than `gap`
  matter  ///< the inside of a solid: a cabinet that stands on the floor, a desk leg that ends in it
};

/// sides  per triangle (charts.h): solids carry light on one side.   p, n  scene-local, n unit.
/// gap    m.
Cover coverOf(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
              const geometry::RayCaster& caster, const vec3& p, const vec3& n, float gap);

/// Directions about a normal that tell matter: stratified by the cosine. t, b, n orthonormal.
inline constexpr std::size_t kMatterProbes = 8;
std::array<vec3, kMatterProbes> matterProbes(const vec3& t, const vec3& b, const vec3& n);
/// More of them that meet the inside of solids tell it. At a foot, or a millimetre under an edge,
/// some do.
inline constexpr int kMostInside = 3;

/// Whether several rays about n from a point meet the inside of solids. One ray along the normal
/// may be mistaken: of a post that stands on a plate and runs into its arm it meets the arm's
/// outside.
bool liesInMatter(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                  const geometry::RayCaster& caster, const vec3& p, const vec3& n);

/// A place on a surface and the area that it stands for.
struct SurfacePlace {
  vec3 point{0.0F};
  std::uint32_t triangle = 0;  ///< the point lies on it
  double area = 0.0;           ///< m^2 that nothing covers
};

/// Reduces a curved chart's place to the part that no matter covers (and, when the place is in the
/// open, that reaches into no gap), told by places on at most 16 of its triangles. Light
/// arrives at and leaves from that part alone. A chart that is covered whole gets area 0. Of the
/// places that may stand for it the nearest to its middle that does not lie in matter is taken.
///
/// n  unit normal of the side.   gap  m.
SurfacePlace exposedPart(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                         const geometry::RayCaster& caster, const Charts& charts,
                         const Chart& chart, const SurfacePlace& whole, const vec3& n, float gap);

}  // namespace soffit::transfer
