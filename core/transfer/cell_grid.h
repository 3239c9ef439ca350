// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/transfer/charts.h"

#include <cstdint>
#include <vector>

namespace soffit::transfer {

/// One cell of a planar chart's grid, clipped to the chart.
struct Cell {
  double area = 0.0;        ///< of the chart inside this cell, m^2
  double total_area = 0.0;  ///< with the slivers of neighbours that joined it
  vec3 point{0.0F};         ///< centre of area when that lies on the chart, else of the largest piece
  std::uint32_t triangle = 0;  ///< mesh triangle of the largest piece
  std::uint32_t owner = 0;     ///< index of the cell it joined; its own when it stands alone
};

struct CellGrid {
  int nu = 1;
  int nv = 1;
  vec2 cell{0.1F};
  std::vector<Cell> cells;  ///< row-major, nu per row
};

/// Cuts a planar chart by a grid of about `wished` metres, evenly dividing its extent.
CellGrid cutIntoCells(const geometry::Mesh& mesh, const Charts& charts, const Chart& chart, double wished);

}  // namespace soffit::transfer
