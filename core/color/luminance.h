// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// Luminance of linear Rec.709 colours: the Y row of the IEC 61966-2-1 matrix (D65).
namespace soffit::color {

inline constexpr dvec3 kLuminanceRec709{0.2126390058715104, 0.7151686787677560, 0.0721923153607336};

/// Y of a linear Rec.709 triple, in the triple's own unit.
inline double luminance(const dvec3& rgb) {
  return glm::dot(kLuminanceRec709, rgb);
}
inline float luminance(const vec3& rgb) {
  return glm::dot(vec3(kLuminanceRec709), rgb);
}

}  // namespace soffit::color
