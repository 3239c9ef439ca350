// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/scene/material.h"

#include <string_view>

/// Drawing on finished pictures: anti-aliased, in display code values. Positions are in pixels
/// from the top left corner, y down; what lies outside the picture is cut off.
namespace soffit::render {

/// A rectangle in pixels.
struct Area {
  float left = 0.0F, top = 0.0F, right = 0.0F, bottom = 0.0F;
};

/// Blends a colour over a rectangle with rounded corners.
void fillRounded(scene::Image& image, const Area& area, float radius, const vec3& color,
                 float opacity);

/// Blends a straight line with round ends.
void drawLine(scene::Image& image, const vec2& from, const vec2& to, float width, const vec3& color,
              float opacity = 1.0F);

/// Writes a line of UTF-8 text; `at` is the left end of the baseline, `height` that of capitals.
void drawText(scene::Image& image, const vec2& at, float height, std::string_view text,
              const vec3& color);

/// Width of drawText(), px, and the width of its lines.
float textWidth(std::string_view text, float height);
float strokeWidth(float height);

}  // namespace soffit::render
