// SPDX-License-Identifier: MIT
#include "core/color/srgb.h"

#include <cmath>

namespace soffit::color {

float srgbEncode(float linear) {
  const float x = std::abs(linear);
  const float code = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
  return std::copysign(code, linear);
}

float srgbDecode(float code) {
  const float y = std::abs(code);
  const float linear = y <= 0.04045F ? y / 12.92F : std::pow((y + 0.055F) / 1.055F, 2.4F);
  return std::copysign(linear, code);
}

}  // namespace soffit::color
