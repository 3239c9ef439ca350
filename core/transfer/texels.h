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
  light::Receivers receivers;             ///< positions, normals, clusters of at most 256 slots
  std::vector<float> area;                ///< m^2 per slot, exposed; 0 for padding and covered texels
  std::vector<std::uint32_t> material;    ///< per slot
  std::vector<std::uint32_t> triangle;    ///< per slot: a mesh triangle the texel's point lies on
  std::vector<std::uint8_t> openness;     ///< per slot: 0 in a gap, 1 in a hollow, 2 in the open (regions.h)
  std::vector<vec2> uv;                   ///< texture coordinates at the point; (0,0) without
  std::vector<float> uv_width;            ///< side of the texel in texture coordinates; 0 without

  Charts charts;
  double cell = 0.1;                      ///< m
  struct Grid {                           ///< per chart
    std::uint32_t first = 0;              ///< into cells: nu*nv entries per side that is in use
    int nu = 1;
    int nv = 1;
    vec2 cell{0.1F};                      ///< m along t and b
  };
  std::vector<Grid> grids;
  std::vector<std::uint32_t> cells;       ///< slot per grid cell, kNoTexel where the chart has no area

  [[nodiscard]] std::size_t slotCount() const { return area.size(); }
  [[nodiscard]] std::size_t texelCount() const { return receivers.pointCount(); }

  /// How near (m) something stands over most of a texel in a gap; 0 for other texels. A ray from a
  /// gap that ends nearer than this has not left it, even where it meets a texel that is mostly
  /// outside: that part of the texel is dark.
  [[nodiscard]] float gapReach(std::size_t slot) const {
    return openness[slot] == 0 ? static_cast<float>(kGapShare * cell) : 0.0F;
  }
  static constexpr double kGapShare = 0.35;  ///< of a cell

  /// The texel of a point on a mesh triangle, seen from its front or back; kNoTexel when that
  /// side carries no light (the inside of a closed solid).
  [[nodiscard]] std::uint32_t at(std::uint32_t mesh_triangle, bool front, const vec3& point) const;

  /// Up to four texels of the same chart and side around a point with weights that sum to 1
  /// (bilinear between cell centres; cells without a texel give theirs to the others). Returns
  /// how many; 0 when the side carries none.
  int around(std::uint32_t mesh_triangle, bool front, const vec3& point, std::array<std::uint32_t, 4>& slots,
             std::array<float, 4>& weights) const;
};

/// Lays texels over a mesh.
///
/// sides  per triangle (charts.h).   cell  grid size in m, > 0.
/// Cells that a chart's edge cuts to less than a twentieth join a neighbour; the sum of texel
/// areas equals the area of all lit sides up to rounding.
///
/// caster  rays find what part of each texel is covered by other things (exposure.h: its area counts
///         the exposed part alone, 0 when nothing is), and, from cell to cell just above the
///         surface, where walls stand on it: no cluster reaches through one. Null: neither.
Texels makeTexels(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell,
                  const geometry::RayCaster* caster);

/// The cell size at which makeTexels gives about `count` texels (within 3 %, never below), not
/// smaller than `least_cell`.
double cellForCount(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, std::size_t count,
                    double least_cell);

}  // namespace soffit::transfer
