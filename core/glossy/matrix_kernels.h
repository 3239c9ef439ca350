// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/half.h"

#include <cstddef>

/// The loops of matrix_set.h over one block of 16 receivers, SIMD for every instruction set.
namespace soffit::glossy {

/// Most coefficients of light that the kernels take: 6 bands.
inline constexpr std::size_t kMaxLightCoefficients = 36;

/// Where a block's light is: one for all ([channel][coefficient]) or one each
/// ([channel][coefficient][16]).
struct BlockLight {
  const float* values = nullptr;
  bool each = false;
};

/// arriving [channel][n][16] = M light. symmetric: rows hold j >= i, else all j. Three channels.
void applyMatrixBlock(const transfer::Half* matrix, bool symmetric, std::size_t n, BlockLight light,
                      float* arriving);

/// out [rows][16] = F in, F row-major rows x columns, in [columns][16].
void multiplyBlock(const float* matrix, std::size_t rows, std::size_t columns,
                   const transfer::Half* in, float* out);

/// radiance [3][16] = sum of scaled_basis [n][16] times arriving [3][n][16].
void dotBlock(const float* scaled_basis, const float* arriving, std::size_t n, float* radiance);

}  // namespace soffit::glossy
