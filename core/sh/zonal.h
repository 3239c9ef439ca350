// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/index.h"

#include "core/math/vec.h"

#include <functional>
#include <span>
#include <vector>

/// Functions that are symmetric about an axis.
///
/// Two descriptions of one function f(t), t = cosine of the angle from its axis:
/// coefficients along z, f_l = integral f y_l0, and the kernel k_l = 2 pi integral f(t) P_l(t) dt
/// by which convolution multiplies band l (Funk-Hecke): k_l = f_l sqrt(4 pi / (2l + 1)).
namespace soffit::sh {

/// k_l for l = 0 .. bands - 1, unit [f] sr.
using Kernel = std::vector<double>;

struct ZonalOptions {
  int bands = 3;
  /// Cosines inside (-1, 1) where f or a derivative jumps, in any order.
  std::vector<double> breakpoints;
  int nodes = 32;  ///< Gauss-Legendre nodes between breakpoints
};

/// The `bands` coefficients f_l along z of f(cos theta). Exact up to rounding where f is a
/// polynomial of degree 2 nodes - bands or less between breakpoints.
std::vector<double> projectZonal(const std::function<double(double)>& f,
                                 const ZonalOptions& options);

/// k_l = f_l sqrt(4 pi / (2l + 1)), and back.
Kernel kernelFromZonal(std::span<const double> zonal);
std::vector<double> zonalFromKernel(std::span<const double> kernel);

/// All n^2 coefficients of the function with that kernel turned from z to `axis` (unit):
/// k_l y_lm(axis). No rotation matrix is needed.
Coefficients zonalAbout(std::span<const double> kernel, const dvec3& axis);

/// max(0, t): pi, 2 pi / 3, pi / 4, 0, -pi / 24 .. (Ramamoorthi & Hanrahan 2001), by the recurrence
/// A_{l+2} = -A_l (l - 1) / (l + 4); odd degrees above 1 vanish.
Kernel clampedCosineKernel(int bands);

/// Normalised Phong lobe (s + 1) / 2 pi max(0, t)^s, s >= 0: 1, (s + 1) / (s + 2),
/// k_l = k_{l-2} (s - l + 2) / (s + l + 1). s = 1 is the clamped cosine over pi.
Kernel phongKernel(double exponent, int bands);

/// Normalised von Mises-Fisher lobe kappa / (4 pi sinh kappa) e^(kappa t), kappa >= 0: ratios of
/// modified spherical Bessel functions, by downward recurrence; full accuracy.
Kernel vonMisesFisherKernel(double kappa, int bands);

/// exp(-l (l + 1) / 2 kappa), the usual approximation: within 1 % at kappa = 50, 10 % at 10 up to
/// l = 9, useless near 1.
Kernel vonMisesFisherApproximation(double kappa, int bands);

/// GGX distribution of half vectors D(t) t with alpha = roughness^2 in (0, 1], 2 pi integral
/// D t P_l(t) dt: 1 at l = 0 (D is normalised so); alpha = 1 is the clamped cosine over pi.
Kernel ggxHalfVectorKernel(double alpha, int bands);

/// The reflected GGX lobe at normal incidence without masking, 2 pi integral D t P_l(2t^2 - 1) dt:
/// degree 9 of alpha .1/.2/.3/.4 is .303/.058/.009/.001, so 10 bands serve alpha >= 0.2.
/// Lobes off the normal are not zonal.
Kernel ggxReflectedKernel(double alpha, int bands);

/// A cap of the sphere: f = 1 where the sine of the angle is below sin_radius within 90 degrees of
/// the axis; sin_radius in [0, 1]. k_l = 2 pi sin_radius^2 P'_l(c) / (l (l + 1)) with c the cosine
/// of the radius, which does not cancel for small disks as (P_{l-1} - P_{l+1}) / (2l + 1) does.
Kernel capKernel(double sin_radius, int bands);

/// P_l(t) for l = 0 .. bands - 1, and P'_l(t).
std::vector<double> legendreValues(double t, int bands);
std::vector<double> legendreSlopes(double t, int bands);

}  // namespace soffit::sh
