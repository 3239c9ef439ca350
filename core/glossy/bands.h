// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/zonal.h"

#include <optional>

/// Which number of bands serves which roughness (numerics.md 1.8), and by what a lobe cut off there
/// errs.
///
/// Everything is about the reflected GGX lobe at normal incidence, whose kernel k_l
/// (sh::ggxReflectedKernel) falls with l the faster the rougher the surface is. alpha =
/// roughness^2, in (0, 1].
namespace soffit::glossy {

/// k_{n-1}, the last kernel value kept, below which a lobe counts as served by n bands: alpha 0.4
/// with 5 bands (0.064), alpha 0.2 with 10 (0.058).
inline constexpr double kServedKernel = 0.065;

/// The fewest bands of 3, 4, 5 and on to sh::kMaxBands that serve the lobe; none for sharper ones,
/// which are left to reflection mapping or rays.
std::optional<int> bandsFor(double alpha);

/// The least alpha that `bands` serve (3 .. sh::kMaxBands), to 1e-6.
double leastAlphaFor(int bands);

/// RMS over all directions of what the lobe loses by the cut, as a share of its own RMS: the error
/// of a highlight of a light that is a point, the worst case. By Parseval from the closed form
/// integral of lobe^2 = (1 + alpha^2 + alpha^4) / (12 pi alpha^2).
double pointLightError(double alpha, int bands);

/// The same for the light of half the sphere, bright above a plane and dark below (a wall's edge),
/// RMS of the error over directions as a share of the bright side: what a lobe loses of an edge.
/// Summed to degree 400, which is enough for alpha >= 0.02.
double edgeError(double alpha, int bands);

/// The Phong exponent s whose lobe (s + 1) / 2 pi cos^s has the same mean cosine k_1: (s + 1) /
/// (s + 2) = k_1. Defined where k_1 > 1/2 (alpha below about 0.43), below that 0.
double phongExponentFor(double alpha);

}  // namespace soffit::glossy
