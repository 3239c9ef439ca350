// SPDX-License-Identifier: MIT
#include "core/geometry/plan_mask.h"

#include <algorithm>

namespace soffit::geometry {
namespace {

/// The largest rectangle that stands on row `j`, whose columns reach `rise[i]` cells up to it.
CellRectangle belowSkyline(const std::vector<int>& rise, int j) {
  CellRectangle best;
  std::vector<int> open;  // columns with growing rises
  const int columns = static_cast<int>(rise.size());
  for (int i = 0; i <= columns; ++i) {
    const int now = i < columns ? rise[static_cast<std::size_t>(i)] : 0;
    while (!open.empty() && rise[static_cast<std::size_t>(open.back())] >= now) {
      const int tall = rise[static_cast<std::size_t>(open.back())];
      open.pop_back();
      const int left = open.empty() ? 0 : open.back() + 1;
      const CellRectangle found{{left, j + 1 - tall}, {i, j + 1}};
      if (found.area() > best.area()) best = found;
    }
    open.push_back(i);
  }
  return best;
}

}  // namespace

CellRectangle largestRectangle(const PlanMask& mask) {
  CellRectangle best;
  std::vector<int> rise(static_cast<std::size_t>(mask.nx), 0);
  for (int j = 0; j < mask.ny; ++j) {
    for (int i = 0; i < mask.nx; ++i) {
      int& r = rise[static_cast<std::size_t>(i)];
      r = mask.at(i, j) ? r + 1 : 0;
    }
    const CellRectangle found = belowSkyline(rise, j);
    if (found.area() > best.area()) best = found;
  }
  return best;
}

std::vector<int> stepsInside(const PlanMask& mask) {
  const auto nx = static_cast<std::size_t>(mask.nx);
  std::vector<int> steps(mask.inside.size(), 0);
  const auto at = [&](int i, int j) {
    return mask.at(i, j) ? steps[static_cast<std::size_t>(j) * nx + static_cast<std::size_t>(i)]
                         : 0;
  };
  // Two sweeps of the chessboard distance transform.
  const auto relax = [&](int i, int j, int towards, int least) {
    if (!mask.at(i, j)) return least;
    for (int d = -1; d <= 1; ++d) least = std::min(least, at(i + d, j + towards) + 1);
    return std::min(least, at(i + towards, j) + 1);
  };
  const int far = mask.nx + mask.ny;
  for (int j = 0; j < mask.ny; ++j) {
    for (int i = 0; i < mask.nx; ++i) {
      if (!mask.at(i, j)) continue;
      steps[static_cast<std::size_t>(j) * nx + static_cast<std::size_t>(i)] = relax(i, j, -1, far);
    }
  }
  for (int j = mask.ny - 1; j >= 0; --j) {
    for (int i = mask.nx - 1; i >= 0; --i) {
      if (mask.at(i, j)) {
        int& s = steps[static_cast<std::size_t>(j) * nx + static_cast<std::size_t>(i)];
        s = relax(i, j, 1, s);
      }
    }
  }
  return steps;
}

}  // namespace soffit::geometry
