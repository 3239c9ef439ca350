// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/transfer/gather_lists.h"
#include "core/transfer/half.h"

#include <cstdint>
#include <span>

/// The loops that run on every move, for the widest vector unit at hand (Highway).
namespace soffit::transfer {

/// y[k] = gather list first+k of x, k < y.size(); x: RGB + padding per slot.
void gather(const GatherLists& lists, std::size_t first, std::span<const vec4> x,
            std::span<vec4> y);

/// out_c[s] += sum_k weights[k*slots + s] y[k].c for c = x, y, z; slots a multiple of 16.
void interpolate(std::span<const Half> weights, std::span<const vec4> y, std::size_t slots, float* out_r,
                 float* out_g, float* out_b);

/// y[t] += scale * x[t] for t < n.
void addScaled(float scale, const float* x, float* y, std::size_t n);

}  // namespace soffit::transfer
