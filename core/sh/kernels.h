// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/index.h"

#include <cstddef>
#include <span>

/// SIMD kernels over many directions or many receivers, one source for every instruction set
/// (Google Highway, chosen at run time). Structure of arrays: coefficient i of item k is at
/// [i * stride + k].
namespace soffit::sh {

/// Products are summed in single precision over this many samples, then in double.
inline constexpr std::size_t kKernelBlock = 256;

/// y_lm of many unit directions x[k], y[k], z[k] into values[i * stride + k], by the recurrence.
/// The spans are equally long, n <= stride; bands in 1 .. kMaxBands. Float; worst error 7e-6.
void evaluateBatch(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                   int bands, std::size_t stride, float* values);

/// sums[c] = sum over k of row[k] * channels[c][k], for 1 or 3 channels of equal length; `row`
/// holds whole blocks of kKernelBlock. See ProjectionTable::project() for the accuracy.
void sumOfProducts(const float* row, std::span<const std::span<const float>> channels,
                   double* sums);

/// values[k] = sum over i of coefficients[i] * rows[i * stride + k]: the dot product of n
/// receivers' transfer vectors with one light (Sloan et al. 2002), or the value of one function at
/// n directions. values.size() <= stride; float.
void dotBatch(std::span<const float> coefficients, const float* rows, std::size_t stride,
              std::span<float> values);

/// The same for red, green and blue light in one pass over the rows.
void dotBatch(std::span<const float> red, std::span<const float> green, std::span<const float> blue,
              const float* rows, std::size_t stride, std::span<float> red_values,
              std::span<float> green_values, std::span<float> blue_values);

}  // namespace soffit::sh
