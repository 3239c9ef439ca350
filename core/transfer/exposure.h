// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/transfer/texels.h"

namespace soffit::transfer {

/// What stands over a point of a surface, by a ray along its normal.
enum class Cover {
  none,
  gap,     ///< a surface, nearer than `gap`
  matter,  ///< the inside of a solid: a cabinet that stands on the floor, a desk leg that ends in
           ///< it
};

/// sides  per triangle (charts.h): solids carry light on one side.   p, n  scene-local, n unit.
/// gap    m.
Cover coverOf(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
              const geometry::RayCaster& caster, const vec3& p, const vec3& n, float gap);

/// Texels under way: draft indices, one entry each.
struct DraftTexels {
  std::span<vec3> position;
  std::span<const vec3> normal;
  std::span<float> area;
  std::span<std::uint32_t> triangle;
};

/// Reduces each texel to the part that nothing covers (and, in the open, that reaches into no gap),
/// told by 16 samples: its area becomes the exposed area, its point the exposed sample nearest to
/// the exposed centre. Light arrives at and leaves from that part alone; counting the rest would
/// lose energy wherever furniture stands on something. A texel that is covered whole gets area 0
/// and keeps its point.
///
/// texels  charts, grids and cells, which hold draft indices.
void measureExposure(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                     const geometry::RayCaster& caster, const Texels& texels,
                     const DraftTexels& draft);

}  // namespace soffit::transfer
