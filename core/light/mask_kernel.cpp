// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/mask_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "core/light/blocker_lanes.h"
#include "core/light/lanes-inl.h"
#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {

/// The edges of 16 blockers as functions of receiver and place on the light. With the receiver p,
/// the corner q, the edge e and the light's place x = origin + a u + b v, the triple product
/// -((q - p) x e).(x - p) is positive where the edge's plane leaves x on the blocker's side (for a
/// receiver in front); it is linear in p and in x. All positions are relative to one receiver of
/// the group, which keeps the constants as small as the products themselves.
struct EdgeForms {
  static constexpr std::size_t kNumbers = 12;  ///< c0, c1, c2; each a constant and a gradient in p
  alignas(64) float form[BlockerRow::kCorners][kNumbers][BlockerLanes::kBlock];
  alignas(64) float height[BlockerLanes::kBlock];  ///< of that receiver over the blocker's plane
};

/// The light as the forms take it.
struct LightFrame {
  vec3 eye;     ///< the receiver that all is relative to
  vec3 origin;  ///< relative to it
  vec3 u, v;
};

HWY_INLINE V3 columns3(const BlockerLanes& in, std::size_t row, std::size_t step, std::size_t at) {
  return {hn::LoadU(d, in.row(row) + at), hn::LoadU(d, in.row(row + step) + at),
          hn::LoadU(d, in.row(row + 2 * step) + at)};
}

HWY_INLINE void makeForms(const BlockerLanes& in, std::size_t first, const LightFrame& light,
                          EdgeForms& forms) {
  const std::size_t edges = in.five() ? BlockerRow::kCorners : BlockerRow::kCorners - 1;
  const V3 eye = set3(light.eye);
  const V3 origin = set3(light.origin);
  const V3 lu = set3(light.u);
  const V3 lv = set3(light.v);
  for (std::size_t lane = 0; lane < BlockerLanes::kBlock; lane += hn::Lanes(d)) {
    const std::size_t at = first + lane;
    const V3 n = columns3(in, BlockerRow::kNx, 1, at);
    hn::Store(hn::Sub(dot(n, eye), hn::LoadU(d, in.row(BlockerRow::kD) + at)), d,
              forms.height + lane);
    V3 q = sub(columns3(in, BlockerRow::kX, BlockerRow::kCorners, at), eye);
    for (std::size_t k = 0; k < edges; ++k) {
      const std::size_t after = (k + 1) % BlockerRow::kCorners;
      const V3 next = sub(columns3(in, BlockerRow::kX + after, BlockerRow::kCorners, at), eye);
      const V3 e = sub(next, q);
      const V3 m = cross(q, e);
      const V3 g0 = cross(sub(q, origin), e);
      const V3 g1 = cross(e, lu);
      const V3 g2 = cross(e, lv);
      const V numbers[EdgeForms::kNumbers] = {hn::Neg(dot(m, origin)), g0.x, g0.y, g0.z,
                                              hn::Neg(dot(m, lu)),     g1.x, g1.y, g1.z,
                                              hn::Neg(dot(m, lv)),     g2.x, g2.y, g2.z};
      for (std::size_t i = 0; i < EdgeForms::kNumbers; ++i) {
        hn::Store(numbers[i], d, forms.form[k][i] + lane);
      }
      q = next;
    }
  }
}

/// An edge as seen on the light: f(a, b) = c0 + a c1 + b c2 is positive where the edge's plane
/// leaves the place (a, b) on the blocker's side (design.md section 3, step 4).
struct EdgePlane {
  V c0, c1, c2;
};

HWY_INLINE EdgePlane edgePlane(const float (*form)[BlockerLanes::kBlock], std::size_t blocker,
                               const V3& p) {
  const auto value = [&](std::size_t i) HWY_ATTR {
    return hn::MulAdd(hn::Set(d, form[i + 1][blocker]), p.x,
                      hn::MulAdd(hn::Set(d, form[i + 2][blocker]), p.y,
                                 hn::MulAdd(hn::Set(d, form[i + 3][blocker]), p.z,
                                            hn::Set(d, form[i][blocker]))));
  };
  return {value(0), value(4), value(8)};
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

/// Bounds on the column by row j, T_j = a + j b, of each receiver: from below where f rises along a
/// row, from above where it falls.
struct RowBounds {
  static constexpr std::size_t kMost = BlockerRow::kCorners;
  alignas(64) float lo_a[kMost][16], lo_b[kMost][16];
  alignas(64) float hi_a[kMost][16], hi_b[kMost][16];
  int lo_count = 0;
  int hi_count = 0;
};

HWY_INLINE void addBound(const EdgePlane& f, RowBounds& bounds) {
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
  // Mostly all receivers agree.
  const V far = hn::Set(d, 1e8F);
  if (!hn::AllFalse(d, rising)) {
    hn::Store(hn::IfThenElse(rising, a, hn::Neg(far)), d, bounds.lo_a[bounds.lo_count]);
    hn::Store(hn::IfThenElseZero(rising, b), d, bounds.lo_b[bounds.lo_count++]);
  }
  if (!hn::AllTrue(d, rising)) {
    hn::Store(hn::IfThenElse(rising, far, a), d, bounds.hi_a[bounds.hi_count]);
    hn::Store(hn::IfThenZeroElse(rising, b), d, bounds.hi_b[bounds.hi_count++]);
  }
}

/// Offsets o_j of the rows.
struct RowOffsets {
  alignas(64) float offset[MaskLight::kRows];
};
constexpr RowOffsets kOffsets = [] {
  RowOffsets o{};
  for (int j = 0; j < MaskLight::kRows; ++j) o.offset[j] = MaskLight::rowOffset(j);
  return o;
}();

/// ORs the intervals between the bounds into the rows of one receiver, which lie side by side: a
/// blocker mostly concerns few of the receivers. Returns whether all bits are set then.
HWY_INLINE bool fillRows(const RowBounds& bounds, std::size_t receiver, std::uint32_t* hidden) {
  const VU all = hn::Set(du, 0xffffffffU);
  // Adding 1.5 * 2^23 leaves the nearest integer in the low bits: cheaper than a conversion that
  // minds overflow.
  constexpr float kMagic = 12582912.0F;
  const VU magic = hn::BitCast(du, hn::Set(d, kMagic));
  VU full = all;
  for (std::size_t j = 0; j < MaskLight::kRows; j += hn::Lanes(d)) {
    const V row = hn::Iota(d, static_cast<float>(j));
    V lo = hn::Zero(d);
    V hi = hn::Set(d, 32.0F);
    for (int k = 0; k < bounds.lo_count; ++k) {
      lo = hn::Max(lo, hn::MulAdd(row, hn::Set(d, bounds.lo_b[k][receiver]),
                                  hn::Set(d, bounds.lo_a[k][receiver])));
    }
    for (int k = 0; k < bounds.hi_count; ++k) {
      hi = hn::Min(hi, hn::MulAdd(row, hn::Set(d, bounds.hi_b[k][receiver]),
                                  hn::Set(d, bounds.hi_a[k][receiver])));
    }
    lo = hn::Min(lo, hn::Set(d, 40.0F));
    hi = hn::Max(hi, hn::Set(d, -8.0F));
    // Columns i with lo <= i + o <= hi: rounding x + 1/2 is the ceiling, x - 1/2 the floor; ties
    // are edges that meet a sample exactly. An empty interval leaves no common bit.
    const V offset = hn::Load(d, kOffsets.offset + j);
    const V below = hn::Add(hn::Add(lo, hn::Sub(hn::Set(d, 0.5F), offset)), hn::Set(d, kMagic));
    const V above = hn::Add(hn::Sub(hn::Add(hn::Set(d, 31.5F), offset), hi), hn::Set(d, kMagic));
    const VU bits = hn::And(shiftUp(all, hn::Sub(hn::BitCast(du, below), magic)),
                            shiftDown(all, hn::Sub(hn::BitCast(du, above), magic)));
    const VU rows = hn::Or(hn::Load(du, hidden + j), bits);
    hn::Store(rows, du, hidden + j);
    full = hn::And(full, rows);
  }
  return hn::AllTrue(du, hn::Eq(full, all));
}

HWY_INLINE std::uint32_t bitsOf(const M& mask) {
  std::uint8_t packed[8] = {};
  hn::StoreMaskBits(d, mask, packed);
  return packed[0] | (hn::Lanes(d) > 8 ? static_cast<std::uint32_t>(packed[1]) << 8U : 0U);
}

/// Lanes(d) receivers of a MaskShadow.
struct Piece {
  V3 p;    ///< relative to the frame's eye
  M open;  ///< receivers that are asked for and still see some of the light
  std::uint32_t (*hidden)[MaskLight::kRows];
};

/// Hides what lies behind a blocker.
HWY_INLINE void hide(const BlockerLanes& list, std::size_t first, std::size_t k,
                     const EdgeForms& forms, float epsilon, Piece& piece) {
  const auto number = [&](std::size_t row) { return list.row(row)[first + k]; };
  const V height = hn::MulAdd(hn::Set(d, number(BlockerRow::kNx)), piece.p.x,
                              hn::MulAdd(hn::Set(d, number(BlockerRow::kNy)), piece.p.y,
                                         hn::MulAdd(hn::Set(d, number(BlockerRow::kNz)), piece.p.z,
                                                    hn::Set(d, forms.height[k]))));
  const M front = hn::Gt(height, hn::Set(d, epsilon));
  const bool sheet = number(BlockerRow::kSolid) == 0.0F;
  M active = front;
  if (sheet) active = hn::Or(front, hn::Lt(height, hn::Set(d, -epsilon)));
  active = hn::And(active, piece.open);
  if (hn::AllFalse(d, active)) return;
  const V zero = hn::Zero(d);
  const V sign = hn::IfThenElse(front, hn::Set(d, 1.0F), hn::Set(d, -1.0F));
  EdgePlane planes[RowBounds::kMost];
  const int count = static_cast<int>(number(BlockerRow::kCount));
  for (int e = 0; e < count; ++e) {
    EdgePlane& f = planes[e];
    f = edgePlane(forms.form[e], k, piece.p);
    if (sheet) f = {hn::Mul(f.c0, sign), hn::Mul(f.c1, sign), hn::Mul(f.c2, sign)};
    // f is linear: its extremes are at corners of the light.
    const V most = hn::Add(f.c0, hn::Add(hn::Max(f.c1, zero), hn::Max(f.c2, zero)));
    active = hn::And(active, hn::Gt(most, zero));
    if (hn::AllFalse(d, active)) return;
  }
  // Edges that leave all of the light on the blocker's side bound nothing.
  RowBounds bounds;
  M whole = active;
  for (int e = 0; e < count; ++e) {
    const EdgePlane& f = planes[e];
    const V least = hn::Add(f.c0, hn::Add(hn::Min(f.c1, zero), hn::Min(f.c2, zero)));
    const M inside = hn::Gt(least, zero);
    whole = hn::And(whole, inside);
    if (!hn::AllFalse(d, hn::AndNot(inside, active))) addBound(f, bounds);
  }
  std::uint32_t closed = bitsOf(whole);
  for (std::uint32_t bits = closed; bits != 0; bits &= bits - 1) {
    std::uint32_t* const rows = piece.hidden[std::countr_zero(bits)];
    std::fill_n(rows, MaskLight::kRows, 0xffffffffU);
  }
  for (std::uint32_t bits = bitsOf(hn::AndNot(whole, active)); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(bits));
    if (fillRows(bounds, i, piece.hidden[i])) closed |= 1U << i;
  }
  if (closed != 0) {
    const std::uint8_t packed[8] = {static_cast<std::uint8_t>(closed & 255U),
                                    static_cast<std::uint8_t>(closed >> 8U)};
    piece.open = hn::AndNot(hn::LoadMaskBits(d, packed), piece.open);
  }
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

/// Visible bits by cell for each receiver: a word per band of four rows, a byte per cell, at most
/// 32 each.
HWY_INLINE void countCells(const std::uint32_t (*hidden)[MaskLight::kRows],
                           std::uint32_t (*cells)[16]) {
  alignas(64) std::uint32_t counts[MaskLight::kRows];
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    for (std::size_t j = 0; j < MaskLight::kRows; j += hn::Lanes(d)) {
      hn::Store(byteCounts(hn::Not(hn::Load(du, hidden[i] + j))), du, counts + j);
    }
    for (std::size_t band = 0; band < 4; ++band) {
      const std::uint32_t* const c = counts + 4 * band;
      cells[band][i] = (c[0] + c[1]) + (c[2] + c[3]);
    }
  }
}

HWY_INLINE void weigh(const MaskLight& light, const V3& p, const V3& n,
                      const std::uint32_t (*hidden)[MaskLight::kRows], std::size_t lane,
                      MaskSums& sums) {
  alignas(64) std::uint32_t cells[4][16];
  countCells(hidden, cells);
  V visible = hn::Zero(d);
  V total = hn::Zero(d);
  V plain = hn::Zero(d);
  float plain_total = 0.0F;
  const hn::Rebind<std::int32_t, D> di;
  for (std::size_t cell = 0; cell < MaskLight::kCells; ++cell) {
    if (light.cell_count[cell] == 0.0F) continue;
    const VU shift = hn::Set(du, static_cast<std::uint32_t>(8 * (cell % 4)));
    const VU byte = hn::And(hn::Shr(hn::Load(du, cells[cell / 4]), shift), hn::Set(du, 255U));
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
  addToSums(lane, visible, total, plain, plain_total, sums);
}

HWY_INLINE V3 positions(const MaskReceivers& r, std::size_t lane) {
  return {hn::LoadU(d, r.x + lane), hn::LoadU(d, r.y + lane), hn::LoadU(d, r.z + lane)};
}

void Hide(MaskShadow::State& state, const MaskLight& light, const MaskReceivers& r,
          const BlockerLanes& blockers, float epsilon) {
  const vec3 eye(r.x[0], r.y[0], r.z[0]);
  const LightFrame frame{eye, light.origin - eye, light.u, light.v};
  EdgeForms forms;
  for (std::size_t first = 0; first < blockers.size() && state.open != 0;
       first += BlockerLanes::kBlock) {
    makeForms(blockers, first, frame, forms);
    const std::size_t count = std::min(blockers.size() - first, BlockerLanes::kBlock);
    for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
      Piece piece{sub(positions(r, lane), set3(eye)), lanesOf(state.open, lane),
                  &state.hidden[lane]};
      for (std::size_t k = 0; k < count && !hn::AllFalse(d, piece.open); ++k) {
        hide(blockers, first, k, forms, epsilon, piece);
      }
      const std::uint32_t here = (hn::Lanes(d) == 16 ? 0xffffU : (1U << hn::Lanes(d)) - 1U) << lane;
      state.open = (state.open & ~here) | bitsOf(piece.open) << lane;
    }
  }
}

void Weigh(const MaskShadow::State& state, const MaskLight& light, const MaskReceivers& r,
           MaskSums& sums) {
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    if (hn::AllFalse(d, lanesOf(r.lanes, lane))) continue;
    const V3 n{hn::LoadU(d, r.nx + lane), hn::LoadU(d, r.ny + lane), hn::LoadU(d, r.nz + lane)};
    weigh(light, positions(r, lane), n, &state.hidden[lane], lane, sums);
  }
}

const char* TargetName() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(Hide);
HWY_EXPORT(Weigh);
HWY_EXPORT(TargetName);

MaskShadow::MaskShadow(const MaskLight& light, const MaskReceivers& receivers)
    : light_(light), receivers_(receivers) {
  for (auto& rows : state_.hidden) {
    for (std::size_t j = 0; j < MaskLight::kRows; ++j) rows[j] = ~light.outline[j];
  }
  state_.open = receivers.lanes & 0xffffU;
}

bool MaskShadow::hide(const BlockerLanes& blockers, float epsilon) {
  HWY_DYNAMIC_DISPATCH(Hide)(state_, light_, receivers_, blockers, epsilon);
  return state_.open == 0;
}

void MaskShadow::addTo(MaskSums& sums) const {
  HWY_DYNAMIC_DISPATCH(Weigh)(state_, light_, receivers_, sums);
}

const char* simdTargetName() {
  return HWY_DYNAMIC_DISPATCH(TargetName)();
}

}  // namespace soffit::light
#endif
