// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/light/receivers.h"
#include "core/transfer/charts.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Source texels: the points where direct light and radiosity live, and what the viewport shows.
namespace soffit::transfer {

inline constexpr std::uint32_t kNoTexel = 0xffffffffU;

/// All texels of a scene, in the order of their clusters' slots (light::Receivers): a texel's
/// index is its slot. Padding slots repeat a texel with area 0.
struct Texels {
  light::Receivers receivers;           ///< positions, normals, clusters of at most 256 slots
  std::vector<float> area;              ///< m^2 per slot that nothing covers; 0 for padding
  std::vector<std::uint32_t> material;  ///< per slot
  std::vector<std::uint32_t> triangle;  ///< per slot: a mesh triangle the texel's point lies on
  std::vector<std::uint8_t>
      openness;  ///< per slot: 0 in a gap, 1 in a hollow, 2 in the open (regions.h)
  std::vector<std::uint32_t>
      part;  ///< per slot: light is not interpolated from one part to another (regions.h)
  std::vector<vec2> uv;         ///< texture coordinates at the point; (0,0) without
  std::vector<float> uv_width;  ///< side of the texel in texture coordinates; 0 without

  Charts charts;
  double cell = 0.1;  ///< m, side of a whole base cell
  /// Per planar chart: nu x nv fine cells, ku x kv of which make a base cell (cell_grid.h). A
  /// curved chart is one cell.
  struct Grid {
    std::uint32_t first = 0;       ///< into cells: nu*nv entries per side that is in use
    std::uint32_t first_base = 0;  ///< into split: (nu/ku)*(nv/kv) entries per side
    std::int32_t nu = 1;
    std::int32_t nv = 1;
    std::int32_t ku = 1;
    std::int32_t kv = 1;
    vec2 cell{0.1F};  ///< m along t and b of a fine cell
  };
  std::vector<Grid> grids;
  std::vector<std::uint32_t> cells;  ///< slot per fine cell, kNoTexel where no light can be
  std::vector<std::uint8_t> split;   ///< per base cell: 1 where it holds several texels
  /// Per fine cell, bits: nothing stands between it and the next along t (1), along b (2), and
  /// light reaches both. Empty: not known, nothing is covered.
  std::vector<std::uint8_t> links;

  [[nodiscard]] std::size_t slotCount() const { return area.size(); }
  [[nodiscard]] std::size_t texelCount() const { return receivers.pointCount(); }

  /// How near (m) something stands over most of a texel in a gap; 0 for other texels. A ray from a
  /// gap that ends nearer than this has not left it, even where it meets a texel that is mostly
  /// outside: that part of the texel is dark.
  [[nodiscard]] float gapReach(std::size_t slot) const {
    return openness[slot] == 0 ? static_cast<float>(kGapShare * cell) : 0.0F;
  }
  static constexpr double kGapShare = 0.27;  ///< of a cell

  /// The texel of a point on a mesh triangle, seen from its front or back; kNoTexel when that
  /// side carries no light (the inside of a closed solid).
  [[nodiscard]] std::uint32_t at(std::uint32_t mesh_triangle, bool front, const vec3& point) const;

  /// Texels of the same chart, side and part around a point, with weights that sum to 1: bilinear
  /// between the centres of base cells; within a base cell that is split, bilinear between the fine
  /// cells next to the point. Cells of another part, without a texel, or behind a
  /// wall as far as those base cells show, give their weight to the
  /// others. Returns how many; 0 when the side carries none.
  static constexpr std::size_t kMostAround = 16;
  int around(std::uint32_t mesh_triangle, bool front, const vec3& point,
             std::array<std::uint32_t, kMostAround>& slots,
             std::array<float, kMostAround>& weights) const;

 private:
  struct Near;
  [[nodiscard]] std::uint32_t sideOffset(const Chart& chart, bool front,
                                         std::uint32_t per_side) const {
    return !front && (chart.sides & kFront) != 0 ? per_side : 0U;
  }
};

/// Lays texels over a mesh.
///
/// sides   per triangle (charts.h).   cell  side of a base cell in m, > 0.
/// caster  rays find what is covered by other things (such cells carry no light, and their area is
///         not counted: Cover), where light may change within a cell, and where walls stand on a
///         surface: no cluster reaches through one. Null: nothing is covered or split.
/// count   with a caster: cells are split, where a wall or gap does not ask for it anyway, until
/// there are about so many texels (cell_splits.h).
///
/// Fine cells that a chart's edge cuts to less than a twentieth join a neighbour; the sum of texel
/// areas equals the area of all lit sides that nothing covers, up to the samples' resolution.
/// useful  when given, gets the number of splits that tell more than a little apart.
Texels makeTexels(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell,
                  const geometry::RayCaster* caster, std::size_t count = 0,
                  std::size_t* useful = nullptr);

/// The cell size at which makeTexels gives about `count` texels (within 3 %, never below), not
/// smaller than `least_cell`.
double cellForCount(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                    std::size_t count, double least_cell);

}  // namespace soffit::transfer
