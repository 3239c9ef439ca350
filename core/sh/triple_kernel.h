// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/triple_product.h"

namespace soffit::sh {

/// TripleProduct::multiplyBatch(): SIMD across items, one source for every instruction set.
void multiplyBatchKernel(std::span<const TripleEntry> entries, std::size_t coefficients,
                         const float* a, const float* b, float* c, std::size_t n,
                         std::size_t stride);

}  // namespace soffit::sh
