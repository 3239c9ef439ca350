// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace soffit::prt {

/// A rectangle's place in an atlas, in cells; x < 0: it did not fit.
struct PackedPlace {
  int x = -1;
  int y = -1;
};

struct Packing {
  std::vector<PackedPlace> places;  ///< in the order of the sizes given
  int height = 0;                   ///< cells in use
};

/// Packs rectangles into a strip of a given width, tallest first, each at the lowest (then
/// leftmost) place above the skyline of those before it (Jylänki 2010, "A Thousand Ways to Pack
/// the Bin", skyline bottom-left). Sizes >= 1 in each direction and not wider than the strip.
/// Deterministic; O(n x corners of the skyline).
Packing packRectangles(std::span<const glm::ivec2> sizes, int width);

}  // namespace soffit::prt
