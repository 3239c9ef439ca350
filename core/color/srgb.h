// SPDX-License-Identifier: MIT
#pragma once

/// The sRGB transfer curve, IEC 61966-2-1.
namespace soffit::color {

/// Code value of a linear value; both nominally 0..1. The curve is continued above 1 and mirrored
/// below 0, so that nothing is lost. NaN stays NaN.
float srgbEncode(float linear);

/// Linear value of a code value; the inverse of srgbEncode().
float srgbDecode(float code);

}  // namespace soffit::color
