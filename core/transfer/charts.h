// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

/// Surfaces cut into charts: connected coplanar triangles of one material, or, where geometry is
/// small or curved, patches of neighbouring triangles that look roughly the same way.
namespace soffit::transfer {

/// Which sides of a triangle see light: bits.
enum Sides : std::uint8_t { kNoSide = 0, kFront = 1, kBack = 2, kBothSides = 3 };

struct Chart {
  bool planar = true;             ///< a grid of cells; otherwise the whole chart is one texel
  std::uint8_t sides = kBothSides;
  std::uint32_t material = 0;
  vec3 origin{0.0F};              ///< planar: corner of the grid, on the plane
  vec3 t{1.0F, 0.0F, 0.0F};       ///< planar: unit axes, (t, b, normal) right-handed
  vec3 b{0.0F, 1.0F, 0.0F};
  vec3 normal{0.0F, 0.0F, 1.0F};  ///< front, unit (the mean for a curved chart)
  vec2 size{0.0F};                ///< planar: extent along t and b, m
  double area = 0.0;
  std::uint32_t first_triangle = 0;  ///< range in Charts::triangles
  std::uint32_t triangle_count = 0;
};

struct Charts {
  std::vector<Chart> charts;
  std::vector<std::uint32_t> triangles;  ///< mesh triangle indices by chart
  std::vector<std::uint32_t> chart_of;   ///< per mesh triangle
};

/// Partitions the mesh.
///
/// sides  per triangle, which sides are to carry light (components.h tells closed solids).
/// cell   wished texel size in m: coplanar regions below half a cell's area join curved charts
///        of up to one cell's area.
/// Deterministic; O(n log n).
Charts makeCharts(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell);

}  // namespace soffit::transfer
