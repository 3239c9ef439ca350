// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/cull_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/light/cull_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, CullBlock::kSize>;
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

/// Least n.x over the corners.
HWY_INLINE V leastHeight(const CullBlock& block, std::size_t lane, const vec4& plane) {
  const V px = hn::Set(d, plane.x);
  const V py = hn::Set(d, plane.y);
  const V pz = hn::Set(d, plane.z);
  V least = hn::Set(d, 1e30F);
  for (std::size_t c = 0; c < CullBlock::kCorners; ++c) {
    const V at = hn::MulAdd(px, hn::Load(d, &block.x[c][lane]),
                            hn::MulAdd(py, hn::Load(d, &block.y[c][lane]),
                                       hn::Mul(pz, hn::Load(d, &block.z[c][lane]))));
    least = hn::Min(least, at);
  }
  return least;
}

CullResult Cull(const CullBlock& block, std::span<const vec4> planes, const Box& receivers,
                const vec4* cut) {
  const vec3 center = receivers.center();
  const vec3 half = 0.5F * receivers.size();
  CullResult result;
  for (std::size_t lane = 0; lane < CullBlock::kSize; lane += hn::Lanes(d)) {
    // Height of the box's highest corner above the blocker's plane.
    const V nx = hn::Load(d, &block.nx[lane]);
    const V ny = hn::Load(d, &block.ny[lane]);
    const V nz = hn::Load(d, &block.nz[lane]);
    V height = hn::Neg(hn::Load(d, &block.d[lane]));
    height = hn::MulAdd(nx, hn::Set(d, center.x), height);
    height = hn::MulAdd(ny, hn::Set(d, center.y), height);
    height = hn::MulAdd(nz, hn::Set(d, center.z), height);
    height = hn::MulAdd(hn::Abs(nx), hn::Set(d, half.x), height);
    height = hn::MulAdd(hn::Abs(ny), hn::Set(d, half.y), height);
    height = hn::MulAdd(hn::Abs(nz), hn::Set(d, half.z), height);
    auto stays = hn::Gt(height, hn::Zero(d));
    for (const vec4& plane : planes) {
      stays = hn::And(stays, hn::Lt(leastHeight(block, lane, plane), hn::Set(d, plane.w)));
      if (hn::AllFalse(d, stays)) break;
    }
    const std::uint32_t all = bitsOf(stays);
    std::uint32_t behind = 0;
    if (cut != nullptr && all != 0) {
      behind = all & bitsOf(hn::Le(leastHeight(block, lane, *cut), hn::Set(d, cut->w)));
    }
    result.whole |= (all & ~behind) << lane;
    result.cut |= behind << lane;
  }
  return result;
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(Boxes);
HWY_EXPORT(Cull);

std::uint32_t cullBoxes(const BoxBlock& block, std::span<const vec4> planes) {
  return HWY_DYNAMIC_DISPATCH(Boxes)(block, planes);
}

CullResult cullBlock(const CullBlock& block, std::span<const vec4> planes, const Box& receivers,
                     const vec4* cut) {
  return HWY_DYNAMIC_DISPATCH(Cull)(block, planes, receivers, cut);
}

}  // namespace soffit::light
#endif
