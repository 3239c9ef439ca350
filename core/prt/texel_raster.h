// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/prt/surfaces.h"
#include "core/prt/texture_layout.h"

#include <cstdint>
#include <vector>

namespace soffit::prt {

/// The position buffer of a transfer texture (PRTT): for every texel that a chart touches, where
/// on the surface its light is computed.
struct RasterTexel {
  std::uint32_t texel = 0;  ///< y * width + x
  std::uint32_t chart = 0;
  std::uint32_t triangle = 0;  ///< of the mesh
  bool front = true;
  float u = 0.0F, v = 0.0F;  ///< barycentric: (1-u-v) a + u b + v c
  float area = 0.0F;         ///< of the surface in this texel, m^2
  float coverage = 0.0F;     ///< of the texel's square, 0..1
};

/// Conservative: every texel whose square a triangle touches, ascending, each once. The point is
/// the texel's centre where that lies on a triangle, else the centre of gravity of the largest
/// piece: on the surface and away from its edge, where another wall may stand. Pieces are clipped
/// exactly, so that areas sum to those of all sides that receive light (to rounding). Texels that a
/// chart covers to less than 2 % give their area to the fullest of their neighbors of the same
/// chart, where there is one, and are left out. A cancelled job leaves texels out.
std::vector<RasterTexel> rasterize(const Surfaces& surfaces, const TextureLayout& layout,
                                   const Job& job = {});

}  // namespace soffit::prt
