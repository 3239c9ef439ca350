// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/transfer/texels.h"

#include <span>
#include <vector>

namespace soffit::transfer {

/// Who may share what. Texels of one region may share clusters, and with them patches and weights;
/// light is interpolated within one part.
///
/// Cells of a planar chart belong to one part with their neighbours unless something stands between
/// them (a floor slab under two rooms is two parts), and unless one is sealed from the other. A
/// region is the piece of a part that is about equally bright; pieces of fewer than 16 cells, and
/// curved charts, share one region per openness, brightness and sealed space: position and normal
/// divide those further.
///
/// Brightness is that of a glow by which every metre of air sends the same light (Outlook in
/// regions.cpp): it knows hollows, and nothing of luminaires.
struct Regions {
  std::vector<std::uint32_t> number;  ///< per draft texel: its region
  std::vector<std::uint32_t> part;    ///< per draft texel
  std::vector<std::uint8_t>
      openness;  ///< per draft texel: 0 in a gap, 1 in a hollow, 2 in the open
};

/// texels     charts, grids and cells (which hold draft indices, not slots, at this time).
/// open       per cell: CellOutlook::open.
/// positions, normals  per draft texel.   caster  null: one region per chart and side.
Regions findRegions(const Texels& texels, std::span<const std::uint8_t> open,
                    std::span<const vec3> positions, std::span<const vec3> normals,
                    const geometry::RayCaster* caster);

}  // namespace soffit::transfer
