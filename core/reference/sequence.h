// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>

namespace soffit::reference {

/// The i-th point of a randomised three-dimensional Sobol' sequence in [0, 1)^3.
///
/// Different seeds give independent randomisations (nested uniform scrambling in the hashed form
/// of Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9, 4; direction numbers of Joe &
/// Kuo 2008), each point of which is uniform by itself. The order of the points is scrambled too,
/// so that sets of different seeds can be combined to points of more dimensions. The first 2^k
/// points, any k, are stratified in each coordinate and jointly.
dvec3 sobolPoint(std::uint32_t i, std::uint32_t seed);

}  // namespace soffit::reference
