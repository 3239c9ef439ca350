// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"

#include <span>

/// Values and gradients of the real SH basis at a direction, by the recurrence in l at fixed m on
/// Cartesian coordinates: no trigonometry, no division by sin(theta), no factorial, safe at the
/// poles. Source: Sloan 2013, "Efficient Spherical Harmonic Evaluation"; core/sh/README.md.
namespace soffit::sh {

/// All y_lm at `direction` (unit) for `bands` in 1 .. kMaxBands. values.size() >= bands^2; what is
/// beyond is left alone. Up to 5 bands the unrolled polynomials are used (polynomials.h).
///
/// The error is a few ulp in double, below 7e-6 in float at 10 bands; a direction of length r != 1
/// adds about l |1 - r|.
void evaluate(const dvec3& direction, int bands, std::span<double> values);
void evaluate(const vec3& direction, int bands, std::span<float> values);

/// The same by the recurrence at every number of bands.
void evaluateByRecurrence(const dvec3& direction, int bands, std::span<double> values);
void evaluateByRecurrence(const vec3& direction, int bands, std::span<float> values);

/// Values, and the gradients in R^3 of the polynomials that evaluate() computes. These are one
/// extension of y_lm off the sphere; on it, only the part of a gradient that is tangent to the
/// sphere at `direction` is that of y_lm itself. Spans as for evaluate().
void evaluateWithGradient(const dvec3& direction, int bands, std::span<double> values,
                          std::span<dvec3> gradients);

/// Derivatives of all y_lm at `direction` (unit) along a tangent of the sphere there (any length).
void evaluateDerivative(const dvec3& direction, const dvec3& along, int bands,
                        std::span<double> derivatives);

/// Sum of coefficients times basis: the value at `direction` (unit) of the function they
/// describe. coefficients.size() is the square of the number of bands.
double reconstruct(std::span<const double> coefficients, const dvec3& direction);

}  // namespace soffit::sh
