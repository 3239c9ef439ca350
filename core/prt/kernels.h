// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/receivers.h"
#include "core/transfer/half.h"

#include <cstddef>
#include <span>

/// The inner loops of bake and evaluation, one source for every instruction set (Google Highway,
/// chosen at run time).
namespace soffit::prt {

/// Floats per row of n: rounded up to 16, so that no vector crosses into the next row.
constexpr std::size_t rowStrideOf(std::size_t n) {
  return (n + 15) / 16 * 16;
}

/// out[c] += sum over taps of weight x rows[receiver * stride + c], c < stride; stride a multiple
/// of
/// 16. Single precision, in the order of the taps: error about sqrt(taps) x 6e-8 of the sum of the
/// terms' sizes.
void addRows(const float* rows, std::size_t stride, std::span<const Tap> taps, float* out);

/// Receivers per block of a TransferVectors: one cache line of halves holds a coefficient's.
inline constexpr std::size_t kBlock = 32;

/// Light of one block of receivers, for up to three channels of light on one channel of transfer.
struct BlockLight {
  const float* light[3];  ///< coefficients, `count` each
  float* values[3];       ///< kBlock numbers each, written
};

/// values[c][k] = sum over i < count of light[c][i] x rows[i * kBlock + k], k < kBlock: `blocks`
/// blocks one after another, rows `block_stride` apart, values kBlock apart. channels 1 or 3.
void dotBlocks(const transfer::Half* rows, std::size_t block_stride, std::size_t blocks,
               std::size_t count, std::size_t channels, const BlockLight& at);

}  // namespace soffit::prt
