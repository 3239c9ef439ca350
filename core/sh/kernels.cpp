// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sh/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>
#include <cassert>

#include "core/sh/kernels.h"
#include "core/sh/recurrence.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::sh::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

/// One vector of directions, `count` of its lanes used.
HWY_INLINE void basisOf(const V x, const V y, const V z, int bands, std::size_t stride,
                        std::size_t count, float* out) {
  const Recurrence<float>& r = recurrence<float>();
  const std::size_t lanes = hn::Lanes(d);
  const auto store = [&](std::size_t i, const V value) HWY_ATTR {
    float* to = out + i * stride;
    if (count >= lanes) {
      hn::StoreU(value, d, to);
    } else {
      float all[16];
      hn::StoreU(value, d, all);
      std::copy(all, all + count, to);
    }
  };
  const auto set = [](float v) HWY_ATTR { return hn::Set(d, v); };
  V c = set(1.0F);
  V s = hn::Zero(d);
  for (int m = 0; m < bands; ++m) {
    const auto& steps = r.step[static_cast<std::size_t>(m)];
    V before = hn::Zero(d);
    V q = set(r.start[static_cast<std::size_t>(m)]);
    for (int l = m; l < bands; ++l) {
      if (l > m) {
        const RecurrenceStep<float>& step = steps[static_cast<std::size_t>(l)];
        const V next = hn::MulAdd(hn::Mul(set(step.a), z), q, hn::Mul(set(step.b), before));
        before = q;
        q = next;
      }
      store(index(l, m), hn::Mul(q, c));
      if (m > 0) store(index(l, -m), hn::Mul(q, s));
    }
    const V next_c = hn::NegMulAdd(s, y, hn::Mul(c, x));
    s = hn::MulAdd(c, y, hn::Mul(s, x));
    c = next_c;
  }
}

void EvaluateBatch(const float* x, const float* y, const float* z, std::size_t n, int bands,
                   std::size_t stride, float* values) {
  const std::size_t lanes = hn::Lanes(d);
  std::size_t k = 0;
  for (; k + lanes <= n; k += lanes) {
    basisOf(hn::LoadU(d, x + k), hn::LoadU(d, y + k), hn::LoadU(d, z + k), bands, stride, lanes,
            values + k);
  }
  if (k == n) return;
  float rest[3][16] = {};
  std::copy(x + k, x + n, rest[0]);
  std::copy(y + k, y + n, rest[1]);
  std::copy(z + k, z + n, rest[2]);
  basisOf(hn::LoadU(d, rest[0]), hn::LoadU(d, rest[1]), hn::LoadU(d, rest[2]), bands, stride, n - k,
          values + k);
}

template <std::size_t Channels>
HWY_INLINE void SumChannels(const float* row, const std::span<const float>* channels,
                            double* sums) {
  const std::size_t n = channels[0].size();
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t c = 0; c < Channels; ++c) sums[c] = 0.0;
  for (std::size_t begin = 0; begin < n; begin += kKernelBlock) {
    const std::size_t end = std::min(n, begin + kKernelBlock);
    // Two sums each: the additions of one do not wait for one another.
    V sum[2 * Channels];
    for (V& v : sum) v = hn::Zero(d);
    std::size_t k = begin;
    for (; k + 2 * lanes <= end; k += 2 * lanes) {
      const V w0 = hn::LoadU(d, row + k);
      const V w1 = hn::LoadU(d, row + k + lanes);
      for (std::size_t c = 0; c < Channels; ++c) {
        const float* f = channels[c].data() + k;
        sum[2 * c] = hn::MulAdd(w0, hn::LoadU(d, f), sum[2 * c]);
        sum[2 * c + 1] = hn::MulAdd(w1, hn::LoadU(d, f + lanes), sum[2 * c + 1]);
      }
    }
    for (std::size_t c = 0; c < Channels; ++c) {
      sums[c] += hn::GetLane(hn::SumOfLanes(d, hn::Add(sum[2 * c], sum[2 * c + 1])));
      for (std::size_t j = k; j < end; ++j) sums[c] += double(row[j]) * channels[c][j];
    }
  }
}

void Sum1(const float* row, const std::span<const float>* channels, double* sums) {
  SumChannels<1>(row, channels, sums);
}

void Sum3(const float* row, const std::span<const float>* channels, double* sums) {
  SumChannels<3>(row, channels, sums);
}

/// A strip of receivers at a time: its sums stay in registers over all coefficients.
template <std::size_t Channels>
HWY_INLINE void DotChannels(const float* const* coefficients, std::size_t count, const float* rows,
                            std::size_t stride, std::size_t n, float* const* values) {
  const std::size_t lanes = hn::Lanes(d);
  std::size_t k = 0;
  for (; k + 2 * lanes <= n; k += 2 * lanes) {
    V sum[2 * Channels];
    for (V& v : sum) v = hn::Zero(d);
    for (std::size_t i = 0; i < count; ++i) {
      const V t0 = hn::LoadU(d, rows + i * stride + k);
      const V t1 = hn::LoadU(d, rows + i * stride + k + lanes);
      for (std::size_t c = 0; c < Channels; ++c) {
        const V light = hn::Set(d, coefficients[c][i]);
        sum[2 * c] = hn::MulAdd(t0, light, sum[2 * c]);
        sum[2 * c + 1] = hn::MulAdd(t1, light, sum[2 * c + 1]);
      }
    }
    for (std::size_t c = 0; c < Channels; ++c) {
      hn::StoreU(sum[2 * c], d, values[c] + k);
      hn::StoreU(sum[2 * c + 1], d, values[c] + k + lanes);
    }
  }
  for (; k < n; ++k) {
    for (std::size_t c = 0; c < Channels; ++c) {
      float sum = 0.0F;
      for (std::size_t i = 0; i < count; ++i) sum += coefficients[c][i] * rows[i * stride + k];
      values[c][k] = sum;
    }
  }
}

void Dot1(const float* const* coefficients, std::size_t count, const float* rows,
          std::size_t stride, std::size_t n, float* const* values) {
  DotChannels<1>(coefficients, count, rows, stride, n, values);
}

void Dot3(const float* const* coefficients, std::size_t count, const float* rows,
          std::size_t stride, std::size_t n, float* const* values) {
  DotChannels<3>(coefficients, count, rows, stride, n, values);
}

}  // namespace soffit::sh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::sh {

HWY_EXPORT(EvaluateBatch);
HWY_EXPORT(Sum1);
HWY_EXPORT(Sum3);
HWY_EXPORT(Dot1);
HWY_EXPORT(Dot3);

void evaluateBatch(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                   int bands, std::size_t stride, float* values) {
  assert(x.size() == y.size() && x.size() == z.size() && x.size() <= stride);
  assert(bands >= 1 && bands <= kMaxBands);
  HWY_DYNAMIC_DISPATCH(EvaluateBatch)
  (x.data(), y.data(), z.data(), x.size(), bands, stride, values);
}

void sumOfProducts(const float* row, std::span<const std::span<const float>> channels,
                   double* sums) {
  assert(channels.size() == 1 || channels.size() == 3);
  if (channels.size() == 1) {
    HWY_DYNAMIC_DISPATCH(Sum1)(row, channels.data(), sums);
  } else {
    HWY_DYNAMIC_DISPATCH(Sum3)(row, channels.data(), sums);
  }
}

void dotBatch(std::span<const float> coefficients, const float* rows, std::size_t stride,
              std::span<float> values) {
  assert(values.size() <= stride);
  const float* const light[1] = {coefficients.data()};
  float* const to[1] = {values.data()};
  HWY_DYNAMIC_DISPATCH(Dot1)(light, coefficients.size(), rows, stride, values.size(), to);
}

void dotBatch(std::span<const float> red, std::span<const float> green, std::span<const float> blue,
              const float* rows, std::size_t stride, std::span<float> red_values,
              std::span<float> green_values, std::span<float> blue_values) {
  assert(red.size() == green.size() && red.size() == blue.size());
  assert(red_values.size() <= stride && red_values.size() == green_values.size() &&
         red_values.size() == blue_values.size());
  const float* const light[3] = {red.data(), green.data(), blue.data()};
  float* const to[3] = {red_values.data(), green_values.data(), blue_values.data()};
  HWY_DYNAMIC_DISPATCH(Dot3)(light, red.size(), rows, stride, red_values.size(), to);
}

}  // namespace soffit::sh
#endif
