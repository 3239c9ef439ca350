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
  vec3 point{0.0F};  ///< centre of area when that lies on the chart, else of the largest piece
  std::uint32_t triangle = 0;  ///< mesh triangle of the largest piece
  std::uint32_t owner = 0;     ///< index of the cell it joined; its own when it stands alone
};

struct CellGrid {
  int nu = 1;
  int nv = 1;
  vec2 cell{0.1F};
  std::vector<Cell> cells;  ///< row-major, nu per row
};

/// How a planar chart is cut: base cells of about the wished size, each of ku x kv fine ones (1, 2
/// or 4: strips need no more across). A texel is a whole base cell, a half of it along each axis,
/// or a fine cell.
struct GridLayout {
  int nu = 1;  ///< fine cells along t and b
  int nv = 1;
  int ku = 1;  ///< fine cells per base cell
  int kv = 1;
};

/// size    extent of the chart, m.   wished  base cell, m.
/// fine    false: base cells alone, ku = kv = 1.
GridLayout gridLayout(const vec2& size, double wished, bool fine);

/// Cuts a planar chart by nu x nv cells that divide its extent evenly.
CellGrid cutIntoCells(const geometry::Mesh& mesh, const Charts& charts, const Chart& chart, int nu,
                      int nv);

}  // namespace soffit::transfer
