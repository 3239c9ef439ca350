// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/cull_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>

#include "core/light/cull_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, BlockerLanes::kBlock>;
constexpr D d;
using V = hn::Vec<D>;

HWY_INLINE std::uint32_t bitsOf(const hn::Mask<D>& mask) {
  std::uint8_t packed[8] = {};
  hn::StoreMaskBits(d, mask, packed);
  return packed[0] | (hn::Lanes(d) > 8 ? static_cast<std::uint32_t>(packed[1]) << 8U : 0U);
}

std::uint32_t Boxes(const BoxBlock& block, std::span<const vec4> planes) {
  std::uint32_t bits = 0;
  for (std::size_t lane = 0; lane < BoxBlock::kSize; lane += hn::Lanes(d)) {
    auto stays = hn::Lt(hn::Load(d, &block.lo[0][lane]), hn::Set(d, 1e30F));
    for (const vec4& plane : planes) {
      // The corner that reaches deepest.
      const V x = hn::Load(d, plane.x > 0 ? &block.lo[0][lane] : &block.hi[0][lane]);
      const V y = hn::Load(d, plane.y > 0 ? &block.lo[1][lane] : &block.hi[1][lane]);
      const V z = hn::Load(d, plane.z > 0 ? &block.lo[2][lane] : &block.hi[2][lane]);
      const V least =
          hn::MulAdd(hn::Set(d, plane.x), x,
                     hn::MulAdd(hn::Set(d, plane.y), y, hn::Mul(hn::Set(d, plane.z), z)));
      stays = hn::And(stays, hn::Lt(least, hn::Set(d, plane.w)));
      if (hn::AllFalse(d, stays)) break;
    }
    bits |= bitsOf(stays) << lane;
  }
  return bits;
}

/// 16 columns of a table of blockers.
struct Columns {
  const float* base;
  std::size_t stride;
  std::size_t corners;  ///< rows that may differ

  [[nodiscard]] HWY_INLINE V load(std::size_t row, std::size_t lane) const {
    return hn::LoadU(d, base + row * stride + lane);
  }
};

/// Least n.x over the corners.
HWY_INLINE V leastHeight(const Columns& in, std::size_t lane, const vec4& plane) {
  const V px = hn::Set(d, plane.x);
  const V py = hn::Set(d, plane.y);
  const V pz = hn::Set(d, plane.z);
  V least = hn::Set(d, 1e30F);
  for (std::size_t c = 0; c < in.corners; ++c) {
    const V at = hn::MulAdd(px, in.load(BlockerRow::kX + c, lane),
                            hn::MulAdd(py, in.load(BlockerRow::kY + c, lane),
                                       hn::Mul(pz, in.load(BlockerRow::kZ + c, lane))));
    least = hn::Min(least, at);
  }
  return least;
}

/// Whether the blocker's box meets the hull.
HWY_INLINE hn::Mask<D> meets(const Columns& in, std::size_t lane, const Box& hull) {
  auto stays = hn::FirstN(d, hn::Lanes(d));
  for (const std::size_t row : {BlockerRow::kX, BlockerRow::kY, BlockerRow::kZ}) {
    V lo = in.load(row, lane);
    V hi = lo;
    for (std::size_t c = 1; c < in.corners; ++c) {
      const V at = in.load(row + c, lane);
      lo = hn::Min(lo, at);
      hi = hn::Max(hi, at);
    }
    const auto axis = static_cast<int>(row / BlockerRow::kCorners);
    stays = hn::And(stays, hn::And(hn::Lt(lo, hn::Set(d, hull.hi[axis])),
                                   hn::Gt(hi, hn::Set(d, hull.lo[axis]))));
  }
  return stays;
}

/// Whether the blocker's plane separates something of one box from something of the other.
HWY_INLINE hn::Mask<D> separates(const Columns& in, std::size_t lane, const Box& receivers,
                                 const Box& light) {
  const V nx = in.load(BlockerRow::kNx, lane);
  const V ny = in.load(BlockerRow::kNy, lane);
  const V nz = in.load(BlockerRow::kNz, lane);
  const V zero = hn::Zero(d);
  const auto reach = [&](const Box& box, V& middle, V& half) HWY_ATTR {
    const vec3 c = box.center();
    const vec3 h = 0.5F * box.size();
    middle = hn::Sub(hn::MulAdd(nx, hn::Set(d, c.x),
                                hn::MulAdd(ny, hn::Set(d, c.y), hn::Mul(nz, hn::Set(d, c.z)))),
                     in.load(BlockerRow::kD, lane));
    half =
        hn::MulAdd(hn::Abs(nx), hn::Set(d, h.x),
                   hn::MulAdd(hn::Abs(ny), hn::Set(d, h.y), hn::Mul(hn::Abs(nz), hn::Set(d, h.z))));
  };
  V at_receivers = zero;
  V half_receivers = zero;
  V at_light = zero;
  V half_light = zero;
  reach(receivers, at_receivers, half_receivers);
  reach(light, at_light, half_light);
  const auto front = hn::And(hn::Gt(hn::Add(at_receivers, half_receivers), zero),
                             hn::Lt(hn::Sub(at_light, half_light), zero));
  const auto back = hn::And(hn::Lt(hn::Sub(at_receivers, half_receivers), zero),
                            hn::Gt(hn::Add(at_light, half_light), zero));
  const auto sheet = hn::Eq(in.load(BlockerRow::kSolid, lane), zero);
  return hn::Or(front, hn::And(sheet, back));
}

std::uint32_t Filter(const float* base, std::size_t stride, bool five, std::size_t valid,
                     const BlockerFilter& filter, BlockerLanes& out) {
  const Columns in{base, stride, five ? BlockerRow::kCorners : BlockerRow::kCorners - 1};
  std::uint32_t cut = 0;
  out.reserve(BlockerLanes::kBlock);
  for (std::size_t lane = 0; lane < valid; lane += hn::Lanes(d)) {
    auto stays = hn::And(hn::FirstN(d, valid - lane),
                         hn::Gt(in.load(BlockerRow::kCount, lane), hn::Zero(d)));
    stays = hn::And(stays, separates(in, lane, filter.receivers, filter.light));
    stays = hn::And(stays, meets(in, lane, filter.hull));
    if (hn::AllFalse(d, stays)) continue;
    for (const vec4& plane : filter.planes) {
      stays = hn::And(stays, hn::Lt(leastHeight(in, lane, plane), hn::Set(d, plane.w)));
      if (hn::AllFalse(d, stays)) break;
    }
    if (filter.cut != nullptr && !hn::AllFalse(d, stays)) {
      const auto behind =
          hn::And(stays, hn::Le(leastHeight(in, lane, *filter.cut), hn::Set(d, filter.cut->w)));
      cut |= bitsOf(behind) << lane;
      stays = hn::AndNot(behind, stays);
    }
    if (hn::AllFalse(d, stays)) continue;
    for (std::size_t r = 0; r < BlockerRow::kRows; ++r) {
      hn::CompressStore(in.load(r, lane), stays, d, out.row(r) + out.size());
    }
    out.grow(hn::CountTrue(d, stays));
  }
  return cut;
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(Boxes);
HWY_EXPORT(Filter);

std::uint32_t cullBoxes(const BoxBlock& block, std::span<const vec4> planes) {
  return HWY_DYNAMIC_DISPATCH(Boxes)(block, planes);
}

std::uint32_t filterBlock(const BlockerBlock& in, bool five, const BlockerFilter& filter,
                          BlockerLanes& out) {
  return HWY_DYNAMIC_DISPATCH(Filter)(in.rows[0].data(), BlockerLanes::kBlock, five,
                                      BlockerLanes::kBlock, filter, out);
}

std::uint32_t filterLanes(const BlockerLanes& in, std::size_t first, const BlockerFilter& filter,
                          BlockerLanes& out) {
  if (in.five()) out.markFive();
  return HWY_DYNAMIC_DISPATCH(Filter)(in.row(0) + first, in.stride(), in.five(),
                                      std::min(in.size() - first, BlockerLanes::kBlock), filter,
                                      out);
}

}  // namespace soffit::light
#endif
