// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transfer/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <bit>

#include "core/transfer/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::transfer::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Vectors never exceed 16 lanes, so that strides of 16 always divide.
using D = hn::CappedTag<float, 16>;
constexpr D d;

/// Entries at..at+lanes of which `left` count: slots within the cluster, and rays.
struct Taps {
  hn::Vec<hn::Rebind<std::int32_t, D>> slot;
  hn::Vec<D> rays;
};

HWY_INLINE Taps tapsAt(const GatherLists& lists, std::size_t at, std::size_t left) {
  const hn::Rebind<std::int32_t, D> di;
  const hn::Rebind<std::uint16_t, D> d16;
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN std::uint16_t few[16];
  const std::uint16_t* from = reinterpret_cast<const std::uint16_t*>(&lists.entries[at]);
  if (at + lanes > lists.entries.size()) {  // the last lists: nothing may be read beyond
    for (std::size_t i = 0; i < lanes; ++i) few[i] = i < left ? from[i] : std::uint16_t{0};
    from = few;
  }
  auto packed = hn::PromoteTo(di, hn::LoadU(d16, from));
  if (left < lanes) packed = hn::IfThenElseZero(hn::FirstN(di, left), packed);
  return {hn::And(packed, hn::Set(di, 255)), hn::ConvertTo(d, hn::ShiftRight<8>(packed))};
}

void GatherTinted(const GatherLists& lists, std::size_t first, const TintedLight& light, float* y, std::size_t count) {
  using V = hn::Vec<D>;
  const std::size_t lanes = hn::Lanes(d);
  const hn::Rebind<std::int32_t, D> di;
  for (std::size_t k = 0; k < count; ++k) {
    const GatherLists::List& list = lists.lists[first + k];
    V red = hn::Zero(d);
    V green = hn::Zero(d);
    V blue = hn::Zero(d);
    for (std::uint32_t b = list.first_block; b < list.first_block + list.block_count; ++b) {
      const GatherLists::Block& block = lists.blocks[b];
      if (light.lit[block.cluster] == 0) continue;
      const float* const lux = light.lux.data() + block.base;
      const Palette& palette = light.palettes[block.cluster];
      if (palette.size == 1) {
        V sum = hn::Zero(d);
        for (std::size_t e = 0; e < block.count; e += lanes) {
          const Taps taps = tapsAt(lists, block.first + e, block.count - e);
          sum = hn::MulAdd(taps.rays, hn::GatherIndex(d, lux, taps.slot), sum);
        }
        red = hn::MulAdd(sum, hn::Set(d, palette.rho[0][0]), red);
        green = hn::MulAdd(sum, hn::Set(d, palette.rho[1][0]), green);
        blue = hn::MulAdd(sum, hn::Set(d, palette.rho[2][0]), blue);
      } else if (palette.size != 0 && palette.size <= lanes) {
        const V rho_r = hn::LoadU(d, palette.rho[0].data());
        const V rho_g = hn::LoadU(d, palette.rho[1].data());
        const V rho_b = hn::LoadU(d, palette.rho[2].data());
        for (std::size_t e = 0; e < block.count; e += lanes) {
          const Taps taps = tapsAt(lists, block.first + e, block.count - e);
          const V value = hn::GatherIndex(d, lux, taps.slot);
          const auto place = hn::IndicesFromVec(d, hn::And(hn::BitCast(di, value), hn::Set(di, 15)));
          const V sent = hn::Mul(taps.rays, value);
          red = hn::MulAdd(sent, hn::TableLookupLanes(rho_r, place), red);
          green = hn::MulAdd(sent, hn::TableLookupLanes(rho_g, place), green);
          blue = hn::MulAdd(sent, hn::TableLookupLanes(rho_b, place), blue);
        }
      } else {
        for (std::size_t e = 0; e < block.count; e += lanes) {
          const Taps taps = tapsAt(lists, block.first + e, block.count - e);
          const V sent = hn::Mul(taps.rays, hn::GatherIndex(d, lux, taps.slot));
          red = hn::MulAdd(sent, hn::GatherIndex(d, light.rho[0].data() + block.base, taps.slot), red);
          green = hn::MulAdd(sent, hn::GatherIndex(d, light.rho[1].data() + block.base, taps.slot), green);
          blue = hn::MulAdd(sent, hn::GatherIndex(d, light.rho[2].data() + block.base, taps.slot), blue);
        }
      }
    }
    y[4 * k] = list.scale * hn::GetLane(hn::SumOfLanes(d, red));
    y[4 * k + 1] = list.scale * hn::GetLane(hn::SumOfLanes(d, green));
    y[4 * k + 2] = list.scale * hn::GetLane(hn::SumOfLanes(d, blue));
    y[4 * k + 3] = 0.0F;
  }
}

void GatherRgb(const GatherLists& lists, std::size_t first, const float* x, const std::uint8_t* lit, float* y,
               std::size_t count) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < count; ++k) {
    const GatherLists::List& list = lists.lists[first + k];
    float sum[4] = {0, 0, 0, 0};
    for (std::uint32_t b = list.first_block; b < list.first_block + list.block_count; ++b) {
      const GatherLists::Block& block = lists.blocks[b];
      if (lit != nullptr && lit[block.cluster] == 0) continue;
      for (std::uint32_t e = block.first; e < block.first + block.count; ++e) {
        const float* from = x + 4 * (block.base + lists.entries[e].local);
        const auto n = static_cast<float>(lists.entries[e].count);
        for (int c = 0; c < 4; ++c) sum[c] += n * from[c];
      }
    }
    for (int c = 0; c < 4; ++c) y[4 * k + static_cast<std::size_t>(c)] = sum[c] * list.scale;
  }
#else
  using D4 = hn::CappedTag<float, 4>;
  constexpr D4 d4;
  for (std::size_t k = 0; k < count; ++k) {
    const GatherLists::List& list = lists.lists[first + k];
    auto sum0 = hn::Zero(d4);
    auto sum1 = hn::Zero(d4);
    for (std::uint32_t b = list.first_block; b < list.first_block + list.block_count; ++b) {
      const GatherLists::Block& block = lists.blocks[b];
      if (lit != nullptr && lit[block.cluster] == 0) continue;
      const GatherLists::Entry* entry = &lists.entries[block.first];
      const float* base = x + 4 * static_cast<std::size_t>(block.base);
      std::uint32_t e = 0;
      for (; e + 2 <= block.count; e += 2) {
        const auto n0 = hn::Set(d4, static_cast<float>(entry[e].count));
        const auto n1 = hn::Set(d4, static_cast<float>(entry[e + 1].count));
        sum0 = hn::MulAdd(n0, hn::LoadU(d4, base + 4 * static_cast<std::size_t>(entry[e].local)), sum0);
        sum1 = hn::MulAdd(n1, hn::LoadU(d4, base + 4 * static_cast<std::size_t>(entry[e + 1].local)), sum1);
      }
      if (e < block.count) {
        const auto n0 = hn::Set(d4, static_cast<float>(entry[e].count));
        sum0 = hn::MulAdd(n0, hn::LoadU(d4, base + 4 * static_cast<std::size_t>(entry[e].local)), sum0);
      }
    }
    hn::StoreU(hn::Mul(hn::Add(sum0, sum1), hn::Set(d4, list.scale)), d4, y + 4 * k);
  }
#endif
}

void Interpolate(const float* weights, const float* y, std::size_t rank, std::size_t slots, float* out_r,
                 float* out_g, float* out_b) {
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t s = 0; s < slots; s += lanes) {
    auto r = hn::LoadU(d, out_r + s);
    auto g = hn::LoadU(d, out_g + s);
    auto b = hn::LoadU(d, out_b + s);
    for (std::size_t k = 0; k < rank; ++k) {
      const auto w = hn::LoadU(d, weights + k * slots + s);
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

HWY_EXPORT(GatherTinted);
HWY_EXPORT(GatherRgb);
HWY_EXPORT(Interpolate);
HWY_EXPORT(AddScaled);

void gatherTinted(const GatherLists& lists, std::size_t first, const TintedLight& light, std::span<vec4> y) {
  static_assert(sizeof(GatherLists::Entry) == 2 && std::endian::native == std::endian::little,
                "entries are read as 16-bit words: the slot below, the count above");
  if (y.empty()) return;
  HWY_DYNAMIC_DISPATCH(GatherTinted)(lists, first, light, &y[0].x, y.size());
}

void gather(const GatherLists& lists, std::size_t first, std::span<const vec4> x, std::span<const std::uint8_t> lit_of,
            std::span<vec4> y) {
  static_assert(sizeof(vec4) == 4 * sizeof(float));
  if (y.empty()) return;
  HWY_DYNAMIC_DISPATCH(GatherRgb)(lists, first, &x[0].x, lit_of.empty() ? nullptr : lit_of.data(), &y[0].x, y.size());
}

void interpolate(std::span<const float> weights, std::span<const vec4> y, std::size_t slots, float* out_r,
                 float* out_g, float* out_b) {
  if (y.empty()) return;
  HWY_DYNAMIC_DISPATCH(Interpolate)(weights.data(), &y[0].x, y.size(), slots, out_r, out_g, out_b);
}

void addScaled(float scale, const float* x, float* y, std::size_t n) {
  HWY_DYNAMIC_DISPATCH(AddScaled)(scale, x, y, n);
}

}  // namespace soffit::transfer
#endif
