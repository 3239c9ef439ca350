// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// Colour of a black body, for luminaires that are specified by a colour temperature.
///
/// Planck's law (c2 = 0.014388 m K) is integrated over 360-830 nm with the CIE 1931 2 degree
/// colour matching functions in the multi-lobe fit of Wyman, Sloan & Shirley 2013, "Simple
/// Analytic Approximations to the CIE XYZ Color Matching Functions" (JCGT 2, 2), eq. 4.
namespace soffit::color {

/// CIE XYZ of a black body at `cct_k` kelvin, scaled to Y = 1. Domain: cct_k > 0 and finite.
///
/// The chromaticity x, y is within 0.003 of tabulated colour matching functions from 1500 K to
/// 20000 K (the error is that of the fit); the integral itself adds less than 1e-5.
dvec3 planckianXyz(double cct_k);

/// Linear Rec.709 of an XYZ triple (D65 white, IEC 61966-2-1 primaries). Not clipped.
dvec3 rec709FromXyz(const dvec3& xyz);

/// The inverse of rec709FromXyz(), to rounding.
dvec3 xyzFromRec709(const dvec3& rgb);

}  // namespace soffit::color
