// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/polygon_light.h"

/// SH coefficients of a uniform spherical light seen from a point: a cap, hence zonal
/// (numerics.md 1.7). Luminance 1; metres in one frame; nothing is clipped at a horizon.
namespace soffit::sh {

/// integral of y_lm over the directions from p to the sphere; zero inside it and for a radius of 0
/// or less. Exact to rounding at any distance.
Coefficients sphereCoefficients(const dvec3& center, double radius, const dvec3& p, int bands);

/// The same with gradients by p, sr^1/2 / m. They are unbounded at the surface itself.
CoefficientsWithGradient sphereCoefficientsWithGradient(const dvec3& center, double radius,
                                                        const dvec3& p, int bands);

}  // namespace soffit::sh
