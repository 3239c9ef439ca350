// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/surfaces.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Surfaces cut into charts that lie flat without folding: the first half of an automatic unwrap.
namespace soffit::prt {

/// Triangles of one material that hang together smoothly, flattened.
struct FlatChart {
  std::vector<std::uint32_t> triangles;
  /// Per triangle its corners in the chart's plane, metres, from (0, 0) up.
  std::vector<std::array<vec2, 3>> corners;
  vec2 size{0.0F};  ///< extent, m
};

struct GrowthOptions {
  double cone_deg = 40.0;  ///< how far normals may turn from the chart's first, below 90
  /// m; overlaps smaller than a quarter of it, or a 512th of the chart, are not looked for.
  double texel = 0.05;
};

/// Cuts the given triangles (those that receive light) into charts.
///
/// From the largest triangle left, a chart grows across edges that two triangles share with equal
/// shading normals at both ends (smooth or coplanar), while the faces stay within the cone. It is
/// laid flat by orthogonal projection along the mean normal, so lengths shrink by at most
/// cos(cone + turn of the mean). Triangles that would come to lie on others of their chart (a
/// spiral ramp) are left for another. Planar charts keep right angles and lengths exactly; axes run
/// along the longest edge. Deterministic. Errors of shape: none; any triangle becomes a chart.
std::vector<FlatChart> growCharts(const Surfaces& surfaces,
                                  std::span<const std::uint32_t> triangles,
                                  const GrowthOptions& options);

}  // namespace soffit::prt
