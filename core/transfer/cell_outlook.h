// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/transfer/cell_grid.h"
#include "core/transfer/exposure.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// What is seen from a fine cell.
struct CellOutlook {
  static constexpr std::size_t kProbes = kMatterProbes;
  Cover cover = Cover::none;
  float share = 1.0F;  ///< of the cell that `cover` holds for
  /// Bits: 1 when nothing stands between this cell and the next along t, 2 along b.
  std::uint8_t open = 0;
  vec3 point{0.0F};  ///< where it was looked from
  /// 255 t / (t + scale) of the distance t to the next surface in fixed directions about the
  /// normal: two cells of one chart that receive much the same light have much the same values.
  std::array<std::uint8_t, kProbes> distance{};
};

/// One side of a planar chart. Where the middle of a cell is covered, four more places decide: a
/// cell that is partly in the open is seen from there, and counts for that share.
///
/// front   the side that the chart's normal points to.
/// gap     m: what stands nearer than this over a cell makes it Cover::gap.
/// scale   m, > 0: distances around this one are told apart best.
/// Returns one entry per cell of `cut`; cells without area are left as they are.
std::vector<CellOutlook> lookFromCells(const geometry::Mesh& mesh,
                                       std::span<const std::uint8_t> sides,
                                       const geometry::RayCaster& caster, const Chart& chart,
                                       const CellGrid& cut, bool front, float gap, float scale);

}  // namespace soffit::transfer
