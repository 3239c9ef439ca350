// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"

#include <span>
#include <vector>

/// Windows: factors per band that soften the ringing of a function cut off after n bands.
///
/// For a narrow light at 10 bands the deepest ripple, relative to the peak, is -0.14 raw, -0.027
/// with Hann, -0.042 with Lanczos. What must never be negative needs minimalLaplacian(), which
/// blurs a point to 3 % of its raw peak at 10 bands: for display, not for light that is computed
/// with.
namespace soffit::sh {

/// (1 + cos(pi l / n)) / 2 for l = 0 .. n - 1.
std::vector<double> hannWindow(int bands);

/// sin(pi l / n) / (pi l / n).
std::vector<double> lanczosWindow(int bands);

/// 1 / (1 + lambda l^2 (l + 1)^2), lambda >= 0: the least squared Laplacian (Sloan 2008, "Stupid
/// Spherical Harmonics Tricks", Deringing).
std::vector<double> laplacianWindow(double lambda, int bands);

/// Where a function is least.
struct SphereMinimum {
  dvec3 direction{0.0, 0.0, 1.0};
  double value = 0.0;
};

/// The least value of a function given by coefficients: from the lowest of 24 n^2 directions (at
/// least 256) in each of up to 24 places, half a wave or more apart, gradient steps go downhill
/// until they stand still. Between neighbouring directions lies about a tenth of the shortest wave,
/// so that each valley has several. Checked against 20,000 directions: 1e-6 of the largest
/// coefficient.
SphereMinimum minimumOf(std::span<const double> coefficients);

struct Deringed {
  double lambda = 0.0;  ///< 0: nothing had to be done; infinity: only band 0 is left
  Coefficients coefficients;
};

/// The least lambda whose Laplacian window leaves no negative value, by bisection to 1e-3 of
/// lambda, and the windowed function. Promise: minimumOf() the result is >= -1e-6 of its mean, if
/// the mean (band 0) is not negative; with a negative mean there is no such window and the mean
/// alone is returned.
Deringed minimalLaplacian(std::span<const double> coefficients);

}  // namespace soffit::sh
