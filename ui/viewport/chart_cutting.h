// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <vector>

namespace soffit::ui {

/// A planar chart of texels cut into polygons over which light is all but linear.
///
/// The cuts run through the centres of base cells, where texels are interpolated between; around
/// base cells that are split they run `ku` (`kv`) times as close. Polygons that share an edge share
/// its vertices, so that neither light nor surface has cracks inside a chart.
struct CutChart {
  struct Vertex {
    vec2 at{0.0F};               ///< along the chart's t and b from its origin, m
    std::uint32_t triangle = 0;  ///< a mesh triangle that it lies on
    vec2 barycentric{0.0F};      ///< in it: p = (1-u-v) a + u b + v c
  };
  std::vector<Vertex> vertices;
  std::vector<uvec3> triangles;  ///< turning as the mesh's: front is where the chart's is
};

/// side: 0 for the chart's first side in use (front, if it has one), 1 for the second.
CutChart cutChart(const geometry::Mesh& mesh, const transfer::Texels& texels, std::uint32_t chart,
                  int side);

}  // namespace soffit::ui
