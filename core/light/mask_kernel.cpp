// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/mask_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <span>

#include "core/light/lanes-inl.h"
#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {

/// An edge as seen on the light: f(a, b) = c0 + a c1 + b c2 is positive where the edge's plane
/// leaves the place (a, b) on the blocker's side (design.md section 3, step 4).
struct EdgePlane {
  V c0, c1, c2;
};

HWY_INLINE EdgePlane edgePlane(const V3& v, const vec3& edge, const V& sign, const V3& to_origin,
                               const V3& lu, const V3& lv) {
  const V3 m = cross(v, set3(edge));
  return {hn::Mul(sign, dot(m, to_origin)), hn::Mul(sign, dot(m, lu)), hn::Mul(sign, dot(m, lv))};
}

/// Shifts by any count: what leaves the word is gone. (Other instruction sets take counts
/// modulo 32.)
HWY_INLINE VU shiftUp(const VU& bits, const VU& count) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  return hn::Shl(bits, count);
#else
  const VU most = hn::Set(du, 31U);
  return hn::IfThenZeroElse(hn::Gt(count, most), hn::Shl(bits, hn::Min(count, most)));
#endif
}
HWY_INLINE VU shiftDown(const VU& bits, const VU& count) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  return hn::Shr(bits, count);
#else
  const VU most = hn::Set(du, 31U);
  return hn::IfThenZeroElse(hn::Gt(count, most), hn::Shr(bits, hn::Min(count, most)));
#endif
}

/// Bounds on the column by row j, T_j = a + j b: from below where f rises along a row, from above
/// where it falls.
struct Bound {
  V a, b;
};
template <int kMax>
struct RowBounds {
  Bound lo[kMax], hi[kMax];
  int lo_count = 0;
  int hi_count = 0;
};

template <int kMax>
HWY_INLINE void addBound(const EdgePlane& f, RowBounds<kMax>& bounds) {
  const V c2 = hn::Mul(f.c2, hn::Set(d, 1.0F / MaskLight::kRows));
  // Along a row f = (c0 + j c2) + a e1 with e1 = c1 + c2 (rows are slanted). A vanishing slope
  // means the row is all in or all out: a bounded slope of either sign keeps that decision, and
  // keeps T below 1e8, which still is an integer of 32 bits.
  const V e1 = hn::Add(f.c1, c2);
  const V least =
      hn::MulAdd(hn::Add(hn::Abs(f.c0), hn::Abs(f.c2)), hn::Set(d, 1e-6F), hn::Set(d, 1e-30F));
  const V slope = hn::CopySign(hn::Max(hn::Abs(e1), least), e1);
  // One step of Newton's: 22 bits or more, a column is 1/32.
  V inverse = hn::ApproximateReciprocal(slope);
  inverse = hn::Mul(inverse, hn::NegMulAdd(slope, inverse, hn::Set(d, 2.0F)));
  inverse = hn::Mul(inverse, hn::Set(d, -static_cast<float>(MaskLight::kColumns)));
  const V a = hn::Mul(f.c0, inverse);
  const V b = hn::Mul(c2, inverse);
  const M rising = hn::Gt(slope, hn::Zero(d));
  // Mostly all 16 receivers agree.
  const V far = hn::Set(d, 1e8F);
  if (!hn::AllFalse(d, rising)) {
    bounds.lo[bounds.lo_count++] = {hn::IfThenElse(rising, a, hn::Neg(far)),
                                    hn::IfThenElseZero(rising, b)};
  }
  if (!hn::AllTrue(d, rising)) {
    bounds.hi[bounds.hi_count++] = {hn::IfThenElse(rising, far, a), hn::IfThenZeroElse(rising, b)};
  }
}

/// ORs the intervals between the bounds into the rows.
template <int kLo, int kHi, int kMax>
HWY_INLINE void fillRows(const RowBounds<kMax>& bounds, const float* offsets, VU* hidden) {
  const int lo_count = kLo > 0 ? kLo : bounds.lo_count;
  const int hi_count = kHi > 0 ? kHi : bounds.hi_count;
  const VU all = hn::Set(du, 0xffffffffU);
  // Adding 1.5 * 2^23 leaves the nearest integer in the low bits: cheaper than a conversion that
  // minds overflow.
  constexpr float kMagic = 12582912.0F;
  const VU magic = hn::BitCast(du, hn::Set(d, kMagic));
  for (int j = 0; j < MaskLight::kRows; ++j) {
    const V row = hn::Set(d, static_cast<float>(j));
    V lo = hn::Zero(d);
    V hi = hn::Set(d, 32.0F);
    for (int k = 0; k < lo_count; ++k)
      lo = hn::Max(lo, hn::MulAdd(row, bounds.lo[k].b, bounds.lo[k].a));
    for (int k = 0; k < hi_count; ++k)
      hi = hn::Min(hi, hn::MulAdd(row, bounds.hi[k].b, bounds.hi[k].a));
    lo = hn::Min(lo, hn::Set(d, 40.0F));
    hi = hn::Max(hi, hn::Set(d, -8.0F));
    // Columns i with lo <= i + o <= hi: rounding x + 1/2 is the ceiling, x - 1/2 the floor; ties
    // are edges that meet a sample exactly. An empty interval leaves no common bit.
    const V below = hn::Add(hn::Add(lo, hn::Set(d, 0.5F - offsets[j])), hn::Set(d, kMagic));
    const V above = hn::Add(hn::Sub(hn::Set(d, 31.5F + offsets[j]), hi), hn::Set(d, kMagic));
    const VU bits = hn::And(shiftUp(all, hn::Sub(hn::BitCast(du, below), magic)),
                            shiftDown(all, hn::Sub(hn::BitCast(du, above), magic)));
    hidden[j] = hn::Or(hidden[j], bits);
  }
}

/// Hides what lies inside all edge planes. Returns whether that hides anything from any receiver.
/// edgeAt(k) gives the plane of edge k.
template <int kMax, class EdgeAt>
HWY_INLINE bool hideRows(int count, const EdgeAt& edgeAt, M active, const float* offsets,
                         VU* hidden) {
  EdgePlane planes[kMax];
  for (int k = 0; k < count; ++k) {
    planes[k] = edgeAt(k);
    const EdgePlane& f = planes[k];
    // f is linear: its extremes are at corners of the light.
    const V zero = hn::Zero(d);
    active = hn::And(
        active, hn::Gt(hn::Add(f.c0, hn::Add(hn::Max(f.c1, zero), hn::Max(f.c2, zero))), zero));
    if (hn::AllFalse(d, active)) return false;
  }
  M whole = active;
  for (int k = 0; k < count; ++k) {
    const EdgePlane& f = planes[k];
    const V zero = hn::Zero(d);
    whole = hn::And(whole,
                    hn::Gt(hn::Add(f.c0, hn::Add(hn::Min(f.c1, zero), hn::Min(f.c2, zero))), zero));
  }
  if (!hn::AllFalse(d, whole)) {
    const VU whole_bits = hn::IfThenElseZero(hn::RebindMask(du, whole), hn::Set(du, 0xffffffffU));
    for (int j = 0; j < MaskLight::kRows; ++j) hidden[j] = hn::Or(hidden[j], whole_bits);
    active = hn::AndNot(whole, active);
    if (hn::AllFalse(d, active)) return true;
  }
  RowBounds<kMax> bounds;
  for (int k = 0; k < count; ++k) addBound(planes[k], bounds);
  // Receivers that are not concerned get an interval that begins beyond the last column.
  if (bounds.lo_count == 0) bounds.lo[bounds.lo_count++] = {hn::Set(d, -1e8F), hn::Zero(d)};
  bounds.lo[0] = {hn::IfThenElse(active, bounds.lo[0].a, hn::Set(d, 1e8F)),
                  hn::IfThenElseZero(active, bounds.lo[0].b)};
  switch (10 * bounds.lo_count + bounds.hi_count) {
    case 11:
      fillRows<1, 1>(bounds, offsets, hidden);
      break;
    case 12:
      fillRows<1, 2>(bounds, offsets, hidden);
      break;
    case 21:
      fillRows<2, 1>(bounds, offsets, hidden);
      break;
    case 22:
      fillRows<2, 2>(bounds, offsets, hidden);
      break;
    default:
      fillRows<0, 0>(bounds, offsets, hidden);
      break;
  }
  return true;
}

/// Receivers that still see some of the light.
HWY_INLINE M anyVisible(const MaskLight& light, const VU* hidden) {
  VU visible = hn::Zero(du);
  for (int j = 0; j < MaskLight::kRows; ++j) {
    visible = hn::Or(
        visible, hn::AndNot(hidden[j], hn::Set(du, light.outline[static_cast<std::size_t>(j)])));
  }
  return hn::RebindMask(d, hn::Ne(visible, hn::Zero(du)));
}

/// Set bits of each byte of a word.
HWY_INLINE VU byteCounts(const VU& word) {
#if HWY_TARGET == HWY_SCALAR
  // No byte vectors here: the classic parallel sum within a word.
  const VU pairs = hn::Sub(word, hn::And(hn::ShiftRight<1>(word), hn::Set(du, 0x55555555U)));
  const VU fours = hn::Add(hn::And(pairs, hn::Set(du, 0x33333333U)),
                           hn::And(hn::ShiftRight<2>(pairs), hn::Set(du, 0x33333333U)));
  return hn::And(hn::Add(fours, hn::ShiftRight<4>(fours)), hn::Set(du, 0x0f0f0f0fU));
#else
  const hn::Repartition<std::uint8_t, DU> d8;
  return hn::BitCast(du, hn::PopulationCount(hn::BitCast(d8, word)));
#endif
}

HWY_INLINE void weighRows(const MaskLight& light, const V3& p, const V3& n, const VU* hidden,
                          std::size_t lane, MaskSums& sums) {
  V visible = hn::Zero(d);
  V total = hn::Zero(d);
  V plain = hn::Zero(d);
  float plain_total = 0.0F;
  for (int cy = 0; cy < 4; ++cy) {
    VU packed = hn::Zero(du);  // four byte columns = the four cells of this band, at most 32 each
    for (int j = 4 * cy; j < 4 * cy + 4; ++j) {
      const VU seen =
          hn::AndNot(hidden[j], hn::Set(du, light.outline[static_cast<std::size_t>(j)]));
      packed = hn::Add(packed, byteCounts(seen));
    }
    const hn::Rebind<std::int32_t, D> di;
    for (int cx = 0; cx < 4; ++cx) {
      const auto cell = static_cast<std::size_t>(4 * cy + cx);
      if (light.cell_count[cell] == 0.0F) continue;
      const VU shift = hn::Set(du, static_cast<std::uint32_t>(8 * cx));
      const VU byte = hn::And(hn::Shr(packed, shift), hn::Set(du, 255U));
      const V count = hn::ConvertTo(d, hn::BitCast(di, byte));
      const V3 r = sub(set3(light.cell_center[cell]), p);
      const V r2 = dot(r, r);
      const V cos_p = hn::Max(dot(n, r), hn::Zero(d));
      V weight;
      if (light.lambertian) {
        const V cos_l = hn::Max(hn::Neg(dot(set3(light.normal), r)), hn::Zero(d));
        weight = hn::Div(hn::Mul(cos_p, cos_l), hn::Max(hn::Mul(r2, r2), hn::Set(d, 1e-30F)));
      } else {
        weight = hn::Div(cos_p, hn::Max(hn::Mul(r2, hn::Sqrt(r2)), hn::Set(d, 1e-30F)));
      }
      visible = hn::MulAdd(weight, count, visible);
      total = hn::MulAdd(weight, hn::Set(d, light.cell_count[cell]), total);
      plain = hn::Add(plain, count);
      plain_total += light.cell_count[cell];
    }
  }
  addToSums(lane, visible, total, plain, plain_total, sums);
}

void AddMask(const MaskLight& light, std::span<const MaskBlocker* const> blockers,
             const MaskReceivers& r, float epsilon, MaskSums& sums) {
  float offsets[MaskLight::kRows];
  for (int j = 0; j < MaskLight::kRows; ++j) offsets[j] = MaskLight::rowOffset(j);
  const V3 lu = set3(light.u);
  const V3 lv = set3(light.v);
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const V3 p{hn::LoadU(d, r.x + lane), hn::LoadU(d, r.y + lane), hn::LoadU(d, r.z + lane)};
    const V3 n{hn::LoadU(d, r.nx + lane), hn::LoadU(d, r.ny + lane), hn::LoadU(d, r.nz + lane)};
    const V3 to_origin = sub(set3(light.origin), p);
    VU hidden[MaskLight::kRows];
    for (auto& row : hidden) row = hn::Zero(du);
    const M asked = lanesOf(r, lane);
    M open = asked;
    if (hn::AllFalse(d, open)) continue;
    int since_check = 0;
    const auto finished = [&] {
      if (++since_check < 4) return false;
      since_check = 0;
      open = hn::And(asked, anyVisible(light, hidden));
      return hn::AllFalse(d, open);
    };
    for (const MaskBlocker* const one : blockers) {
      const MaskBlocker& blocker = *one;
      const Facing side = facing(blocker, p, epsilon);
      const M active = hn::And(side.active, open);
      if (hn::AllFalse(d, active)) continue;
      const auto edge = [&](int k) HWY_ATTR {
        const vec3& q = blocker.corners[static_cast<std::size_t>(k)];
        const vec3& next = blocker.corners[static_cast<std::size_t>((k + 1) % blocker.count)];
        return edgePlane(sub(set3(q), p), next - q, side.sign, to_origin, lu, lv);
      };
      if (hideRows<5>(blocker.count, edge, active, offsets, hidden) && finished()) break;
    }
    weighRows(light, p, n, hidden, lane, sums);
  }
}

const char* TargetName() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(AddMask);
HWY_EXPORT(TargetName);

void addMaskVisibility(const MaskLight& light, std::span<const MaskBlocker* const> blockers,
                       const MaskReceivers& receivers, float epsilon, MaskSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddMask)(light, blockers, receivers, epsilon, sums);
}

const char* simdTargetName() {
  return HWY_DYNAMIC_DISPATCH(TargetName)();
}

}  // namespace soffit::light
#endif
