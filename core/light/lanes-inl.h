// SPDX-License-Identifier: MIT
// Vectors of 16 receivers, for the kernels: included once per instruction set, after
// hwy/highway.h.
#if defined(SOFFIT_LIGHT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SOFFIT_LIGHT_LANES_INL_H
#undef SOFFIT_LIGHT_LANES_INL_H
#else
#define SOFFIT_LIGHT_LANES_INL_H
#endif

#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// 16 receivers are handled in pieces of at most 16 lanes.
using D = hn::CappedTag<float, 16>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;
constexpr D d;
constexpr DU du;

struct V3 {
  V x, y, z;
};

HWY_INLINE V3 set3(const vec3& a) {
  return {hn::Set(d, a.x), hn::Set(d, a.y), hn::Set(d, a.z)};
}
HWY_INLINE V3 sub(const V3& a, const V3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

/// Bits [lane, lane + Lanes(d)) as a mask.
HWY_INLINE M lanesOf(std::uint32_t lanes, std::size_t lane) {
  const std::uint32_t bits = lanes >> lane;
  const std::uint8_t packed[8] = {static_cast<std::uint8_t>(bits & 255U),
                                  static_cast<std::uint8_t>(bits >> 8U)};
  return hn::LoadMaskBits(d, packed);
}

/// Which receivers a blocker can hide anything from, and the sign that turns v_k x v_k+1 inward.
struct Facing {
  M active;
  V sign;
  V height;
};

HWY_INLINE Facing facing(const MaskBlocker& blocker, const V3& p, float epsilon) {
  const V height = hn::Sub(dot(set3(blocker.normal), p), hn::Set(d, blocker.d));
  const V eps = hn::Set(d, epsilon);
  const M front = hn::Gt(height, eps);
  const M back = hn::Lt(height, hn::Neg(eps));
  const M active = blocker.solid ? front : hn::Or(front, back);
  // Counter-clockwise seen from the receiver: the cross products point out of the cone.
  return {active, hn::IfThenElse(front, hn::Set(d, -1.0F), hn::Set(d, 1.0F)), height};
}

/// Adds lanes [lane, lane + Lanes(d)) to the sums.
HWY_INLINE void addToSums(std::size_t lane, const V& visible, const V& total, const V& plain,
                          float plain_total, MaskSums& sums) {
  const auto add = [lane](float* to, const V& value) HWY_ATTR {
    hn::StoreU(hn::Add(hn::LoadU(d, to + lane), value), d, to + lane);
  };
  add(sums.visible.data(), visible);
  add(sums.total.data(), total);
  add(sums.plain_visible.data(), plain);
  add(sums.plain_total.data(), hn::Set(d, plain_total));
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
