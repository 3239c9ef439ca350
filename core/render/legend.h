// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/lux_scale.h"
#include "core/scene/material.h"

#include <functional>
#include <string>
#include <vector>

namespace soffit::render {

/// Prints the false-colour legend into the right edge of a picture of display code values: a bar
/// with round values in lux. Scales with the picture; pictures too small to hold a readable
/// legend (under 120 pixels a side) stay as they are.
void drawLegend(scene::Image& image, const color::FalseColorRange& range);
void drawLegend(scene::Image& image, const color::LuxScale& scale);

/// Any other scale: its colors at 0..1 along the bar and the values beside it, in its unit.
struct LegendScale {
  std::function<vec3(float place)> color;
  std::vector<color::LegendTick> ticks;
  std::string unit = "lx";
};
void drawLegend(scene::Image& image, const LegendScale& scale);

/// The most values that a legend of this picture has room for, at least 2.
int legendRoom(const scene::Image& image);

/// Prints a line of text (UTF-8) into the lower left corner; it is cut off where it does not fit.
void drawTitle(scene::Image& image, const std::string& title);

}  // namespace soffit::render
