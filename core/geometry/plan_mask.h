// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <vector>

namespace soffit::geometry {

/// Cells of a plan that belong to something.
struct PlanMask {
  int nx = 0, ny = 0;
  std::vector<std::uint8_t> inside;  ///< nx * ny, x fastest
  [[nodiscard]] bool at(int i, int j) const {
    return i >= 0 && j >= 0 && i < nx && j < ny &&
           inside[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                  static_cast<std::size_t>(i)] != 0;
  }
};

struct CellRectangle {
  glm::ivec2 lo{0};  ///< first cell
  glm::ivec2 hi{0};  ///< one past the last
  [[nodiscard]] int area() const { return (hi.x - lo.x) * (hi.y - lo.y); }
};

/// The rectangle of most cells that lies inside; empty for an empty mask. Row by row, as the
/// largest rectangle below a skyline.
CellRectangle largestRectangle(const PlanMask& mask);

/// Steps from each cell to the nearest one outside, diagonals counted as steps; 0 outside.
std::vector<int> stepsInside(const PlanMask& mask);

}  // namespace soffit::geometry
