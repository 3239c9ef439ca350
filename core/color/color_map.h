// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstddef>

/// The colours that values can be shown in, darkest first.
namespace soffit::color {

enum class ColorMap {
  violet_yellow,  ///< falseColorAt(): by teal; also the OCIO view "False colour"
  blue_yellow,    ///< a straight line in Oklab: two hues that every kind of color blindness tells
                  ///< apart, lightness rising evenly
  grey,           ///< lightness alone, for prints
  spectrum,       ///< blue, cyan, green, yellow, red: what other programs taught. Its lightness
                  ///< rises and falls and red and green look alike to one man in twelve
};

/// In the order of the enumeration.
inline constexpr std::array<ColorMap, 4> kColorMaps{ColorMap::violet_yellow, ColorMap::blue_yellow,
                                                    ColorMap::grey, ColorMap::spectrum};

/// Whether order and value survive every kind of color blindness.
constexpr bool isColorBlindSafe(ColorMap map) {
  return map != ColorMap::spectrum;
}

/// A map is linear in sRGB code values between so many points, at even steps from 0 to 1.
inline constexpr std::size_t kColorMapPoints = 33;
const std::array<vec3, kColorMapPoints>& colorMapPoints(ColorMap map);

/// sRGB code values (0..1) at a place in 0..1; values outside are clamped, NaN counts as 0.
vec3 colorMapAt(ColorMap map, float place);

}  // namespace soffit::color
