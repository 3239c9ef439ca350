// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/false_color.h"
#include "core/scene/material.h"

#include <string>

namespace soffit::render {

/// Prints the false-colour legend into the right edge of a picture of display code values: a bar
/// with round values in lux. Scales with the picture; pictures too small to hold a readable
/// legend (under 120 pixels a side) stay as they are.
void drawLegend(scene::Image& image, const color::FalseColorRange& range);

/// Prints a line of text (UTF-8) into the lower left corner; it is cut off where it does not fit.
void drawTitle(scene::Image& image, const std::string& title);

}  // namespace soffit::render
