// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/transfer/texels.h"

#include <span>
#include <vector>

namespace soffit::transfer {

/// Numbers parts of surfaces that see each other along the surface: cells of a planar chart are
/// joined with their neighbours unless something stands between them, so that a floor slab under
/// two rooms is two regions. Parts of fewer than 16 cells and curved charts share one region per
/// side of the world, numbered after the others; position and normal divide those further.
///
/// texels     charts, grids and cells (which hold draft indices, not slots, at this time).
/// positions, normals  per draft texel.   caster  null: one region per chart and side.
std::vector<std::uint32_t> findRegions(const Texels& texels, std::span<const vec3> positions,
                                       std::span<const vec3> normals, const geometry::RayCaster* caster);

}  // namespace soffit::transfer
