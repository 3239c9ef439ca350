// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>
#include <vector>

/// Where the isolux lines of a picture have room for their values.
namespace soffit::render {

/// A picture's illuminance.
struct LuxPicture {
  int width = 0;
  int height = 0;
  std::vector<float> lux;  ///< row by row from the top; below 0 where no surface is seen
};

struct LineLabel {
  vec2 at{0.0F};  ///< middle of the label, px from the top left corner
  double level = 0.0;
};

struct LabelRoom {
  vec2 size{40.0F, 16.0F};  ///< px, of a label with its margin
  float repeat = 220.0F;    ///< px, least way between two labels of one level
};

/// Labels that cover no second line, no edge of a surface, and not one another; those nearest to
/// the middle of the picture first. levels: ascending.
std::vector<LineLabel> placeLineLabels(const LuxPicture& picture, std::span<const double> levels,
                                       const LabelRoom& room);

}  // namespace soffit::render
