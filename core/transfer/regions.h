// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/transfer/texels.h"

#include <span>
#include <vector>

namespace soffit::transfer {

/// Numbers parts of surfaces that see each other along the surface: cells of a planar chart are
/// joined with their neighbours unless something stands between them, so that a floor slab under
/// two rooms is two regions, unless one lies in a gap and the other in the open, and unless one is
/// sealed from the other. Parts of fewer than 16 cells and curved charts share one region per
/// openness and sealed space; position and normal divide those further.
///
/// texels     charts, grids and cells (which hold draft indices, not slots, at this time).
/// positions, normals  per draft texel.   caster  null: one region per chart and side.
struct Regions {
  std::vector<std::uint32_t> number;  ///< per draft texel
  std::vector<std::uint8_t>
      openness;  ///< per draft texel: 0 in a gap, 1 in a hollow, 2 in the open
};
Regions findRegions(const Texels& texels, std::span<const vec3> positions,
                    std::span<const vec3> normals, const geometry::RayCaster* caster);

}  // namespace soffit::transfer
