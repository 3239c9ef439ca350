// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transfer/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/transfer/kernels.h"
#include "core/transfer/rgb_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::transfer::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Vectors never exceed 16 lanes, so that strides of 16 always divide.
using D = hn::CappedTag<float, 16>;
constexpr D d;

constexpr std::size_t kAhead = 512;  ///< entries, 2 kB

void Gather(const GatherLists& lists, std::size_t first, const float* x, float* y,
            std::size_t count) {
  const auto* const base = reinterpret_cast<const char*>(x);
  const auto at = [base](GatherLists::Entry offset) {
    return loadRgb(reinterpret_cast<const float*>(base + offset));
  };
  for (std::size_t k = 0; k < count; ++k) {
    const GatherLists::List& list = lists.lists[first + k];
    const GatherLists::Entry* e = lists.entries.data() + list.first;
    const auto sumOf = [&at](const GatherLists::Entry* g) {
      return addRgb(addRgb(at(g[0] & ~15U), at(g[1])), addRgb(at(g[2]), at(g[3])));
    };
    // Two sums: a product with addition takes four cycles.
    Rgb s0 = zeroRgb(), s1 = zeroRgb();
    const GatherLists::Entry* const end = e + 4 * static_cast<std::size_t>(list.groups);
    for (; e + 8 <= end; e += 8) {
      // Entries are read once per move: hardware stops looking ahead at each page of memory.
      hwy::Prefetch(e + kAhead);
      s0 = mulAddRgb(GatherLists::kRays[e[0] & 15U], sumOf(e), s0);
      s1 = mulAddRgb(GatherLists::kRays[e[4] & 15U], sumOf(e + 4), s1);
    }
    if (e < end) {
      s0 = mulAddRgb(GatherLists::kRays[e[0] & 15U], sumOf(e), s0);
      e += 4;
    }
    for (std::uint32_t r = 0; r < list.rest; ++r) s1 = addRgb(s1, at(e[r]));
    storeRgb(mulAddRgb(list.scale, addRgb(s0, s1), zeroRgb()), y + 4 * k);
  }
}

void Interpolate(const Half* weights, const float* y, std::size_t rank, std::size_t slots, float* out_r,
                 float* out_g, float* out_b) {
  static_assert(sizeof(Half) == sizeof(hwy::float16_t));
  const std::size_t lanes = hn::Lanes(d);
  const hn::Rebind<hwy::float16_t, D> half;
  for (std::size_t s = 0; s < slots; s += lanes) {
    auto r = hn::LoadU(d, out_r + s);
    auto g = hn::LoadU(d, out_g + s);
    auto b = hn::LoadU(d, out_b + s);
    for (std::size_t k = 0; k < rank; ++k) {
      const auto w = hn::PromoteTo(d, hn::LoadU(half, reinterpret_cast<const hwy::float16_t*>(weights + k * slots + s)));
      r = hn::MulAdd(w, hn::Set(d, y[4 * k]), r);
      g = hn::MulAdd(w, hn::Set(d, y[4 * k + 1]), g);
      b = hn::MulAdd(w, hn::Set(d, y[4 * k + 2]), b);
    }
    hn::StoreU(r, d, out_r + s);
    hn::StoreU(g, d, out_g + s);
    hn::StoreU(b, d, out_b + s);
  }
}

void AddScaled(float scale, const float* x, float* y, std::size_t n) {
  const std::size_t lanes = hn::Lanes(d);
  const auto a = hn::Set(d, scale);
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) hn::StoreU(hn::MulAdd(a, hn::LoadU(d, x + i), hn::LoadU(d, y + i)), d, y + i);
  for (; i < n; ++i) y[i] += scale * x[i];
}

}  // namespace soffit::transfer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::transfer {

HWY_EXPORT(Gather);
HWY_EXPORT(Interpolate);
HWY_EXPORT(AddScaled);

void gather(const GatherLists& lists, std::size_t first, std::span<const vec4> x,
            std::span<vec4> y) {
  static_assert(sizeof(vec4) == 16 && GatherLists::kGroup == 4);
  if (y.empty()) return;
  const float* from = x.empty() ? nullptr : &x[0].x;
  HWY_DYNAMIC_DISPATCH(Gather)(lists, first, from, &y[0].x, y.size());
}

void interpolate(std::span<const Half> weights, std::span<const vec4> y, std::size_t slots, float* out_r,
                 float* out_g, float* out_b) {
  if (y.empty()) return;
  HWY_DYNAMIC_DISPATCH(Interpolate)(weights.data(), &y[0].x, y.size(), slots, out_r, out_g, out_b);
}

void addScaled(float scale, const float* x, float* y, std::size_t n) {
  HWY_DYNAMIC_DISPATCH(AddScaled)(scale, x, y, n);
}

}  // namespace soffit::transfer
#endif
