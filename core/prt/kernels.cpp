// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/prt/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/prt/kernels.h"

#include <algorithm>
#include <cassert>

HWY_BEFORE_NAMESPACE();
namespace soffit::prt::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// At most 16 lanes, so that rows of multiples of 16 always divide.
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

/// N vectors of a row's columns, kept in registers over all taps.
template <std::size_t N>
HWY_INLINE void AddColumns(const float* rows, std::size_t stride, const Tap* taps,
                           std::size_t count, float* out) {
  const std::size_t lanes = hn::Lanes(d);
  V sum[N];
  for (std::size_t v = 0; v < N; ++v) sum[v] = hn::LoadU(d, out + v * lanes);
  for (std::size_t k = 0; k < count; ++k) {
    const float* row = rows + std::size_t{taps[k].receiver} * stride;
    const V weight = hn::Set(d, taps[k].weight);
    for (std::size_t v = 0; v < N; ++v) {
      sum[v] = hn::MulAdd(weight, hn::LoadU(d, row + v * lanes), sum[v]);
    }
  }
  for (std::size_t v = 0; v < N; ++v) hn::StoreU(sum[v], d, out + v * lanes);
}

void AddRows(const float* rows, std::size_t stride, const Tap* taps, std::size_t count,
             float* out) {
  const std::size_t lanes = hn::Lanes(d);
  std::size_t c = 0;
  for (; c + 4 * lanes <= stride; c += 4 * lanes) {
    AddColumns<4>(rows + c, stride, taps, count, out + c);
  }
  for (; c + 2 * lanes <= stride; c += 2 * lanes) {
    AddColumns<2>(rows + c, stride, taps, count, out + c);
  }
  for (; c < stride; c += lanes) AddColumns<1>(rows + c, stride, taps, count, out + c);
}

template <std::size_t Channels>
HWY_INLINE void DotChannels(const transfer::Half* rows, std::size_t block_stride,
                            std::size_t blocks, std::size_t count, const BlockLight& at) {
  static_assert(sizeof(transfer::Half) == sizeof(hwy::float16_t));
  const hn::Rebind<hwy::float16_t, D> half;
  const std::size_t lanes = hn::Lanes(d);
  // Two vectors of receivers at a time: six sums hide the latency of the products.
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto* block = reinterpret_cast<const hwy::float16_t*>(rows + b * block_stride);
    for (std::size_t k = 0; k < kBlock; k += 2 * lanes) {
      V sum[2 * Channels];
      for (V& v : sum) v = hn::Zero(d);
      for (std::size_t i = 0; i < count; ++i) {
        const V t0 = hn::PromoteTo(d, hn::LoadU(half, block + i * kBlock + k));
        const V t1 = hn::PromoteTo(d, hn::LoadU(half, block + i * kBlock + k + lanes));
        for (std::size_t c = 0; c < Channels; ++c) {
          const V light = hn::Set(d, at.light[c][i]);
          sum[2 * c] = hn::MulAdd(t0, light, sum[2 * c]);
          sum[2 * c + 1] = hn::MulAdd(t1, light, sum[2 * c + 1]);
        }
      }
      for (std::size_t c = 0; c < Channels; ++c) {
        hn::StoreU(sum[2 * c], d, at.values[c] + b * kBlock + k);
        hn::StoreU(sum[2 * c + 1], d, at.values[c] + b * kBlock + k + lanes);
      }
    }
  }
}

void Dot1(const transfer::Half* rows, std::size_t block_stride, std::size_t blocks,
          std::size_t count, const BlockLight& at) {
  DotChannels<1>(rows, block_stride, blocks, count, at);
}

void Dot3(const transfer::Half* rows, std::size_t block_stride, std::size_t blocks,
          std::size_t count, const BlockLight& at) {
  DotChannels<3>(rows, block_stride, blocks, count, at);
}

}  // namespace soffit::prt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::prt {

HWY_EXPORT(AddRows);
HWY_EXPORT(Dot1);
HWY_EXPORT(Dot3);

void addRows(const float* rows, std::size_t stride, std::span<const Tap> taps, float* out) {
  assert(stride % 16 == 0);
  HWY_DYNAMIC_DISPATCH(AddRows)(rows, stride, taps.data(), taps.size(), out);
}

void dotBlocks(const transfer::Half* rows, std::size_t block_stride, std::size_t blocks,
               std::size_t count, std::size_t channels, const BlockLight& at) {
  assert(channels == 1 || channels == 3);
  if (channels == 1) {
    HWY_DYNAMIC_DISPATCH(Dot1)(rows, block_stride, blocks, count, at);
  } else {
    HWY_DYNAMIC_DISPATCH(Dot3)(rows, block_stride, blocks, count, at);
  }
}

}  // namespace soffit::prt
#endif
