// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transfer/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/transfer/kernels.h"
#include "core/transfer/rgb_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::transfer::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Vectors never exceed 16 lanes, so that strides of 16 always divide.
using D = hn::CappedTag<float, 16>;
constexpr D d;

/// The four places of a group: entries are offsets in bytes.
struct Group {
  const char* page;
  const GatherLists::Entry* entry;

  HWY_INLINE Rgb single(std::size_t k) const {
    return loadRgb(reinterpret_cast<const float*>(page + entry[k]));
  }
  HWY_INLINE Rgb addTo(Rgb sum, std::size_t k) const {
    const auto* from = reinterpret_cast<const float*>(page + (entry[k] & ~15U));
    return mulAddRgb(GatherLists::kRays[entry[k] & 15U], loadRgb(from), sum);
  }
};

void Gather(const GatherLists& lists, std::size_t first, const float* x, const std::uint8_t* lit,
            float* y, std::size_t count) {
  const auto groupAt = [&](std::size_t g) {
    const std::size_t floats = 4UL * GatherLists::kPage * lists.pages[g];
    return Group{reinterpret_cast<const char*>(x + floats), &lists.entries[4 * g]};
  };
  for (std::size_t k = 0; k < count; ++k) {
    const GatherLists::List& list = lists.lists[first + k];
    const std::size_t mixed = std::size_t{list.first_group} + list.single;
    // Four sums: an addition takes four cycles.
    Rgb s0 = zeroRgb(), s1 = zeroRgb(), s2 = zeroRgb(), s3 = zeroRgb();
    for (std::size_t g = list.first_group; g < mixed; ++g) {
      if (lit != nullptr && lit[lists.pages[g]] == 0) continue;
      const Group group = groupAt(g);
      s0 = addRgb(s0, group.single(0));
      s1 = addRgb(s1, group.single(1));
      s2 = addRgb(s2, group.single(2));
      s3 = addRgb(s3, group.single(3));
    }
    for (std::size_t g = mixed; g < mixed + list.mixed; ++g) {
      if (lit != nullptr && lit[lists.pages[g]] == 0) continue;
      const Group group = groupAt(g);
      s0 = group.addTo(s0, 0);
      s1 = group.addTo(s1, 1);
      s2 = group.addTo(s2, 2);
      s3 = group.addTo(s3, 3);
    }
    storeRgb(mulAddRgb(list.scale, addRgb(addRgb(s0, s1), addRgb(s2, s3)), zeroRgb()), y + 4 * k);
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
            std::span<const std::uint8_t> lit, std::span<vec4> y) {
  static_assert(sizeof(vec4) == 16 && GatherLists::kPage * sizeof(vec4) == 1U << 16U && GatherLists::kGroup == 4);
  if (y.empty()) return;
  const float* from = x.empty() ? nullptr : &x[0].x;
  HWY_DYNAMIC_DISPATCH(Gather)(lists, first, from, lit.empty() ? nullptr : lit.data(), &y[0].x, y.size());
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
