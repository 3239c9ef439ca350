// SPDX-License-Identifier: MIT
#include "core/color/color_map.h"

#include "core/color/false_color.h"
#include "core/color/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::color {
namespace {

/// Relative luminance of an sRGB colour: what is left of it for those who see no colour at all.
double luminanceOf(const vec3& code) {
  return 0.2126 * static_cast<double>(srgbDecode(code.x)) +
         0.7152 * static_cast<double>(srgbDecode(code.y)) +
         0.0722 * static_cast<double>(srgbDecode(code.z));
}

TEST(ColorMap, TheFirstIsTheFalseColoursOfPictures) {
  for (int i = 0; i <= 100; ++i) {
    const float place = static_cast<float>(i) / 100.0F;
    EXPECT_EQ(colorMapAt(ColorMap::violet_yellow, place), falseColorAt(place)) << place;
  }
}

TEST(ColorMap, SafeOnesGrowLighterAllTheWay) {
  for (const ColorMap map : kColorMaps) {
    if (!isColorBlindSafe(map)) continue;
    for (int i = 0; i < 64; ++i) {
      const float place = static_cast<float>(i) / 64.0F;
      EXPECT_LT(luminanceOf(colorMapAt(map, place)),
                luminanceOf(colorMapAt(map, place + 1.0F / 64.0F)))
          << static_cast<int>(map) << " at " << place;
    }
  }
}

/// Viénot, Brettel & Mollon 1999: what a protanope sees of a colour, linear sRGB.
vec3 asProtanope(const vec3& code) {
  const vec3 c(srgbDecode(code.x), srgbDecode(code.y), srgbDecode(code.z));
  const float rg = 0.11238F * c.x + 0.88762F * c.y;
  return {rg, rg, 0.00401F * c.x - 0.00401F * c.y + c.z};
}

TEST(ColorMap, BlueToYellowLooksNearlyTheSameToProtanopes) {
  // Red and green differ little anywhere on it, so what a protanope loses is little: at most this
  // share of white, a bound read off the map (the spectrum loses 0.9).
  float most = 0.0F;
  float spectrum = 0.0F;
  for (int i = 0; i <= 64; ++i) {
    const float place = static_cast<float>(i) / 64.0F;
    const auto loss = [&](ColorMap map) {
      const vec3 code = colorMapAt(map, place);
      const vec3 linear(srgbDecode(code.x), srgbDecode(code.y), srgbDecode(code.z));
      return glm::length(asProtanope(code) - linear);
    };
    most = std::max(most, loss(ColorMap::blue_yellow));
    spectrum = std::max(spectrum, loss(ColorMap::spectrum));
  }
  EXPECT_LT(most, 0.25F);
  EXPECT_GT(spectrum, 3.0F * most);
}

TEST(ColorMap, StaysInRangeForAnyPlace) {
  for (const ColorMap map : kColorMaps) {
    EXPECT_EQ(colorMapAt(map, -1.0F), colorMapAt(map, 0.0F));
    EXPECT_EQ(colorMapAt(map, 2.0F), colorMapAt(map, 1.0F));
    EXPECT_EQ(colorMapAt(map, std::numeric_limits<float>::quiet_NaN()), colorMapAt(map, 0.0F));
    for (const vec3& point : colorMapPoints(map)) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(point[c], 0.0F);
        EXPECT_LE(point[c], 1.0F);
      }
    }
  }
}

}  // namespace
}  // namespace soffit::color
