// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <functional>
#include <span>

namespace soffit::transfer {

/// y = K x for four independent lanes (RGB + padding) at once.
using LaneProduct = std::function<void(std::span<const vec4> x, std::span<vec4> y)>;

/// Solves (I - K) x = g, each lane with a matrix of its own, for K that shrinks (a spectral radius
/// below 1, as light that bounces has): stabilised bi-conjugate gradients (van der Vorst 1992,
/// SIAM J. Sci. Stat. Comput. 13(2), unpreconditioned), which need no symmetry; form factors from
/// rays are only almost symmetric.
///
/// x          becomes the solution; as long as g.
/// tolerance  of the residual, relative to g, per lane; from 1e-6 up (single precision).
/// return     number of products. At most 2 * most + 1; the best x so far if that is not enough.
int solveLanes(const LaneProduct& product, std::span<const vec4> g, std::span<vec4> x,
               double tolerance, int most = 60);

}  // namespace soffit::transfer
