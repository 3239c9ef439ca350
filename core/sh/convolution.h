// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/zonal.h"

#include <span>

/// Convolution of a function on the sphere with a lobe: band l times k_l (Funk-Hecke;
/// Ramamoorthi & Hanrahan 2001).
namespace soffit::sh {

/// Coefficients of g(n) = integral f(d) lobe(d . n) d omega. `kernel` has as many bands as f.
Coefficients convolve(std::span<const double> coefficients, std::span<const double> kernel);

/// Irradiance at a surface of unit normal `n` that sees the whole of distant light `radiance`
/// (cd/m^2 sr^1/2 in, lux out), E = integral L max(0, d . n): the tutorial's unshadowed transfer.
/// The bands beyond those given are what is missed: up to 0.8 % of the energy of the lobe at 3
/// bands, 0.2 % at 5; the sum may be slightly negative where nothing shines.
double irradiance(std::span<const double> radiance, const dvec3& n);

}  // namespace soffit::sh
