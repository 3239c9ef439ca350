// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soffit::prt {

/// Finds triangles of a plane that lie on one another: a grid of points, each of which may be
/// inside of one triangle only. Overlaps that hold no point of the grid pass.
class FlatCover {
 public:
  /// size  of the plane's piece, from (0, 0).   step  of the grid, > 0, raised where the grid would
  /// have more than 4 million points.
  FlatCover(const vec2& size, float step);

  /// Takes the grid points strictly inside of a triangle (either winding), unless one is taken
  /// already: then none, and false.
  bool claim(const std::array<vec2, 3>& corners);

 private:
  float step_;
  int nx_, ny_;
  std::vector<std::uint8_t> taken_;
};

}  // namespace soffit::prt
