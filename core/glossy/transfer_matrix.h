// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/visibility.h"
#include "core/sh/triple_product.h"

#include <span>
#include <vector>

/// Transfer matrices of glossy receivers (Fujita & Kanai 2004; Sloan et al. 2002), in world axes.
///
/// M maps coefficients of the light that would arrive to those of the light that does arrive at a
/// receiver, as a function of direction: M_ij = integral V y_i y_j. The lobe is applied when it is
/// looked at: L_o = sum of k_l (M L)_lm y_lm(axis) (glossyRadiance()), so that roughness may vary
/// from texel to texel and change without a bake.
///
/// A matrix of n bands holds the products of visibility with pairs of harmonics, all of which have
/// degrees up to 2n - 2: it is linear in the first (2n-1)^2 coefficients of V, exactly. 81 numbers
/// make the 625 of 5 bands.
namespace soffit::glossy {

/// The largest number of bands for which (2n-1) bands of visibility exist.
inline constexpr int kMaxMatrixBands = (sh::kMaxBands + 1) / 2;

/// From visibility by direction: row-major, n^2 x n^2, symmetric. bands in 1 .. sh::kMaxBands.
std::vector<double> matrixFromBits(const VisibilityBits& bits, std::size_t receiver,
                                   const sh::SphereSamples& samples, int bands);

/// The same from coefficients of visibility by the triple product tensor of the larger of the two
/// numbers of bands. With 2 bands - 1 of them equal to matrixFromBits() to rounding; with fewer
/// (Dhawal et al. 2022 take as many as the light has) what V has above is lost.
std::vector<double> matrixFromVisibility(std::span<const double> visibility, int bands);

/// The product with a fixed light as a matrix on visibility (TPFL; Dhawal et al. 2022, there with
/// visibility_bands = bands): rows for the n^2 coefficients of what arrives, columns for the
/// visibility_bands^2 of V. F v = M(v) L.
std::vector<double> fixedLightMatrix(std::span<const double> light, int visibility_bands);

/// Radiance toward the eye of a receiver where `arriving` (n^2 coefficients) meets a lobe of kernel
/// k_l about `axis` (unit): sum of k_l c_lm y_lm(axis). kernel: at least n values (lobeKernel()).
double glossyRadiance(std::span<const double> arriving, std::span<const float> kernel,
                      const dvec3& axis);

}  // namespace soffit::glossy
