// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/point_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "core/light/blocker_lanes.h"
#include "core/light/lanes-inl.h"
#include "core/light/light_mask.h"
#include "core/math/box.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {

/// Points are taken in runs of 16, 16 runs at a time.
constexpr std::size_t kRun = 16;
constexpr std::size_t kRuns = 16;

/// Half-spaces a + b.x > 0 for Lanes(d) receivers: those through the receiver and a blocker's
/// edges, and the one beyond its plane. Stored by receiver, for it is the points that are many.
struct Cone {
  static constexpr std::size_t kMost = BlockerRow::kCorners + 1;
  alignas(64) float a[kMost][16];
  alignas(64) float bx[kMost][16], by[kMost][16], bz[kMost][16];
  std::size_t count = 0;

  HWY_INLINE void add(const V& at, const V3& b) {
    hn::Store(at, d, a[count]);
    hn::Store(b.x, d, bx[count]);
    hn::Store(b.y, d, by[count]);
    hn::Store(b.z, d, bz[count]);
    ++count;
  }
};

/// Points relative to the group's first receiver, and the boxes of their runs.
struct Runs {
  alignas(64) float x[kRuns * kRun], y[kRuns * kRun], z[kRuns * kRun];
  alignas(64) float nx[kRuns * kRun], ny[kRuns * kRun], nz[kRuns * kRun], weight[kRuns * kRun];
  alignas(64) float cx[kRuns], cy[kRuns], cz[kRuns], hx[kRuns], hy[kRuns], hz[kRuns];
  Box box;  ///< of all
  std::size_t count = 0;
};

HWY_INLINE void makeRuns(const PointLightSamples& points, std::size_t start, std::size_t end,
                         const vec3& eye, Runs& runs) {
  runs.count = (end - start + kRun - 1) / kRun;
  for (std::size_t run = 0; run < kRuns; ++run) {
    Box box;
    for (std::size_t k = 0; k < kRun; ++k) {
      // Beyond the last: copies of it without weight.
      const std::size_t wanted = start + run * kRun + k;
      const std::size_t i = std::min(wanted, end - 1);
      const vec3 p = vec3(points.x[i], points.y[i], points.z[i]) - eye;
      runs.x[run * kRun + k] = p.x;
      runs.y[run * kRun + k] = p.y;
      runs.z[run * kRun + k] = p.z;
      runs.nx[run * kRun + k] = points.nx[i];
      runs.ny[run * kRun + k] = points.ny[i];
      runs.nz[run * kRun + k] = points.nz[i];
      runs.weight[run * kRun + k] = wanted < end ? points.weight[i] : 0.0F;
      box.add(p);
    }
    const vec3 c = box.center();
    // The middle is rounded: a little more than half the size.
    const vec3 h = 0.5F * box.size() + 1e-6F * (glm::abs(c) + box.size());
    runs.cx[run] = c.x;
    runs.cy[run] = c.y;
    runs.cz[run] = c.z;
    runs.hx[run] = h.x;
    runs.hy[run] = h.y;
    runs.hz[run] = h.z;
    if (run < runs.count) runs.box.add(box);
  }
}

/// The most that a + b.x reaches in a box.
HWY_INLINE V mostIn(const V& a, const V3& b, const V3& center, const V3& half) {
  return hn::Add(hn::Add(a, dot(b, center)),
                 hn::MulAdd(hn::Abs(b.x), half.x,
                            hn::MulAdd(hn::Abs(b.y), half.y, hn::Mul(hn::Abs(b.z), half.z))));
}

HWY_INLINE V3 spread(const Cone& cone, std::size_t plane, std::size_t receiver) {
  return {hn::Set(d, cone.bx[plane][receiver]), hn::Set(d, cone.by[plane][receiver]),
          hn::Set(d, cone.bz[plane][receiver])};
}

HWY_INLINE std::uint32_t bitsOf(const M& mask) {
  std::uint8_t packed[8] = {};
  hn::StoreMaskBits(d, mask, packed);
  return packed[0] | (hn::Lanes(d) > 8 ? static_cast<std::uint32_t>(packed[1]) << 8U : 0U);
}

/// Runs some of whose points may lie in a receiver's cone.
HWY_INLINE std::uint32_t runsInside(const Runs& runs, const Cone& cone, std::size_t receiver) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < runs.count; k += hn::Lanes(d)) {
    const V3 center{hn::Load(d, runs.cx + k), hn::Load(d, runs.cy + k), hn::Load(d, runs.cz + k)};
    const V3 half{hn::Load(d, runs.hx + k), hn::Load(d, runs.hy + k), hn::Load(d, runs.hz + k)};
    V least = hn::Set(d, 1.0F);
    for (std::size_t plane = 0; plane < cone.count; ++plane) {
      least = hn::Min(least, mostIn(hn::Set(d, cone.a[plane][receiver]),
                                    spread(cone, plane, receiver), center, half));
    }
    bits |= bitsOf(hn::Gt(least, hn::Zero(d))) << k;
  }
  return bits & ((1U << runs.count) - 1U);
}

/// The points of a run in a receiver's cone.
HWY_INLINE std::uint32_t pointsInside(const Runs& runs, std::size_t run, const Cone& cone,
                                      std::size_t receiver) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < kRun; k += hn::Lanes(d)) {
    const std::size_t at = run * kRun + k;
    const V3 x{hn::Load(d, runs.x + at), hn::Load(d, runs.y + at), hn::Load(d, runs.z + at)};
    V least = hn::Set(d, 1.0F);
    for (std::size_t plane = 0; plane < cone.count; ++plane) {
      least = hn::Min(least, hn::Add(hn::Set(d, cone.a[plane][receiver]),
                                     dot(spread(cone, plane, receiver), x)));
    }
    bits |= bitsOf(hn::Gt(least, hn::Zero(d))) << k;
  }
  return bits;
}

/// Which points are hidden, by receiver and run.
struct HiddenPoints {
  std::uint32_t words[16][kRuns] = {};
};

/// Makes the cones of blocker k for receivers p; returns those it may hide anything from.
HWY_INLINE M makeCone(const BlockerLanes& list, std::size_t k, const V3& p, const vec3& eye,
                      const Runs& runs, float epsilon, M open, Cone& cone) {
  const auto number = [&](std::size_t row) { return list.row(row)[k]; };
  const vec3 n(number(BlockerRow::kNx), number(BlockerRow::kNy), number(BlockerRow::kNz));
  const float eye_height = glm::dot(n, eye) - number(BlockerRow::kD);
  const V height = hn::Add(dot(set3(n), p), hn::Set(d, eye_height));
  const M front = hn::Gt(height, hn::Set(d, epsilon));
  M active = front;
  if (number(BlockerRow::kSolid) == 0.0F) {
    active = hn::Or(front, hn::Lt(height, hn::Set(d, -epsilon)));
  }
  active = hn::And(active, open);
  if (hn::AllFalse(d, active)) return active;
  const V sign = hn::IfThenElse(front, hn::Set(d, 1.0F), hn::Set(d, -1.0F));
  const V3 center = set3(runs.box.center());
  const V3 half =
      set3(0.5F * runs.box.size() + 1e-6F * (glm::abs(runs.box.lo) + glm::abs(runs.box.hi)));
  const auto add = [&](const V& a, const V3& b) HWY_ATTR {
    cone.add(a, b);
    active = hn::And(active, hn::Gt(mostIn(a, b, center, half), hn::Zero(d)));
    return !hn::AllFalse(d, active);
  };
  cone.count = 0;
  // Beyond the plane; points on it, as a mesh's are on its own triangles, are not hidden by it.
  const V3 down{hn::Mul(sign, hn::Set(d, -n.x)), hn::Mul(sign, hn::Set(d, -n.y)),
                hn::Mul(sign, hn::Set(d, -n.z))};
  const V depth = hn::NegMulAdd(sign, hn::Set(d, eye_height), hn::Set(d, -epsilon));
  if (!add(depth, down)) return active;
  const auto corner = [&](std::size_t c) {
    return vec3(number(BlockerRow::kX + c), number(BlockerRow::kY + c),
                number(BlockerRow::kZ + c)) -
           eye;
  };
  const auto count = static_cast<std::size_t>(number(BlockerRow::kCount));
  vec3 q = corner(0);
  for (std::size_t c = 0; c < count; ++c) {
    const vec3 next = corner((c + 1) % BlockerRow::kCorners);
    // -((q - p) x e).(x - p) = p.m + (p x e - m).x with m = q x e.
    const V3 e = set3(next - q);
    const V3 m = set3(glm::cross(q, next - q));
    const V3 b = sub(cross(p, e), m);
    if (!add(hn::Mul(sign, dot(p, m)),
             {hn::Mul(sign, b.x), hn::Mul(sign, b.y), hn::Mul(sign, b.z)})) {
      return active;
    }
    q = next;
  }
  return active;
}

HWY_INLINE void hidePoints(const Runs& runs, const BlockerLanes& blockers, const MaskReceivers& r,
                           const vec3& eye, float epsilon, HiddenPoints& hidden) {
  Cone cone;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const V3 p = sub({hn::LoadU(d, r.x + lane), hn::LoadU(d, r.y + lane), hn::LoadU(d, r.z + lane)},
                     set3(eye));
    M open = lanesOf(r.lanes, lane);
    for (std::size_t k = 0; k < blockers.size() && !hn::AllFalse(d, open); ++k) {
      const M active = makeCone(blockers, k, p, eye, runs, epsilon, open, cone);
      std::uint32_t closed = 0;
      for (std::uint32_t lanes = bitsOf(active); lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        std::uint32_t* const words = hidden.words[lane + i];
        std::uint32_t touched = runsInside(runs, cone, i);
        if (touched == 0) continue;
        for (; touched != 0; touched &= touched - 1) {
          const auto run = static_cast<std::size_t>(std::countr_zero(touched));
          if (words[run] != 0xffffU) words[run] |= pointsInside(runs, run, cone, i);
        }
        if (std::all_of(words, words + runs.count,
                        [](std::uint32_t word) { return word == 0xffffU; })) {
          closed |= 1U << i;
        }
      }
      if (closed != 0) open = hn::AndNot(lanesOf(closed, 0), open);
    }
  }
}

HWY_INLINE void weighPoints(const Runs& runs, const MaskReceivers& r, const vec3& eye,
                            const HiddenPoints& hidden, MaskSums& sums) {
  for (std::size_t i = 0; i < 16; ++i) {
    if ((r.lanes >> i & 1U) == 0) continue;
    const V3 p = set3(vec3(r.x[i], r.y[i], r.z[i]) - eye);
    const V3 n = set3({r.nx[i], r.ny[i], r.nz[i]});
    V visible = hn::Zero(d);
    V total = hn::Zero(d);
    V plain = hn::Zero(d);
    V plain_total = hn::Zero(d);
    for (std::size_t at = 0; at < runs.count * kRun; at += hn::Lanes(d)) {
      const V3 x{hn::Load(d, runs.x + at), hn::Load(d, runs.y + at), hn::Load(d, runs.z + at)};
      const V3 m{hn::Load(d, runs.nx + at), hn::Load(d, runs.ny + at), hn::Load(d, runs.nz + at)};
      const V share = hn::Load(d, runs.weight + at);
      const V3 to = sub(x, p);
      const V r2 = dot(to, to);
      const V cos_p = hn::Max(dot(n, to), hn::Zero(d));
      // Without a normal the emission has no cosine.
      const M cosine = hn::Gt(dot(m, m), hn::Zero(d));
      const V cos_l =
          hn::IfThenElse(cosine, hn::Max(hn::Neg(dot(m, to)), hn::Zero(d)), hn::Sqrt(r2));
      const V weight = hn::Mul(
          share, hn::Div(hn::Mul(cos_p, cos_l), hn::Max(hn::Mul(r2, r2), hn::Set(d, 1e-30F))));
      const M seen = lanesOf(~hidden.words[i][at / kRun], at % kRun);
      visible = hn::Add(visible, hn::IfThenElseZero(seen, weight));
      total = hn::Add(total, weight);
      plain = hn::Add(plain, hn::IfThenElseZero(seen, share));
      plain_total = hn::Add(plain_total, share);
    }
    sums.visible[i] += hn::GetLane(hn::SumOfLanes(d, visible));
    sums.total[i] += hn::GetLane(hn::SumOfLanes(d, total));
    sums.plain_visible[i] += hn::GetLane(hn::SumOfLanes(d, plain));
    sums.plain_total[i] += hn::GetLane(hn::SumOfLanes(d, plain_total));
  }
}

void AddPoints(const PointLightSamples& points, const BlockerLanes& blockers,
               const MaskReceivers& r, float epsilon, MaskSums& sums) {
  const vec3 eye(r.x[0], r.y[0], r.z[0]);
  for (std::size_t start = 0; start < points.size(); start += kRuns * kRun) {
    const std::size_t end = std::min(points.size(), start + kRuns * kRun);
    Runs runs;
    makeRuns(points, start, end, eye, runs);
    HiddenPoints hidden;
    hidePoints(runs, blockers, r, eye, epsilon, hidden);
    weighPoints(runs, r, eye, hidden, sums);
  }
}

void Facets(const PointLightSamples& points, std::size_t first, const MaskReceivers& r,
            float* value) {
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const V3 p{hn::LoadU(d, r.x + lane), hn::LoadU(d, r.y + lane), hn::LoadU(d, r.z + lane)};
    const V3 n{hn::LoadU(d, r.nx + lane), hn::LoadU(d, r.ny + lane), hn::LoadU(d, r.nz + lane)};
    V sum = hn::Zero(d);
    for (std::size_t k = first; k < points.size(); ++k) {
      const V3 to = sub(set3({points.x[k], points.y[k], points.z[k]}), p);
      const V3 m = set3({points.nx[k], points.ny[k], points.nz[k]});
      const V cos_l = hn::Neg(dot(m, to));
      // Half of a closed mesh looks away from the whole group.
      if (hn::AllFalse(d, hn::Gt(cos_l, hn::Zero(d)))) continue;
      const V cos_p = hn::Max(dot(n, to), hn::Zero(d));
      const V r2 = dot(to, to);
      const V both = hn::Mul(cos_p, hn::Max(cos_l, hn::Zero(d)));
      sum = hn::MulAdd(hn::Set(d, points.weight[k]),
                       hn::Div(both, hn::Max(hn::Mul(r2, r2), hn::Set(d, 1e-30F))), sum);
    }
    hn::StoreU(sum, d, value + lane);
  }
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(AddPoints);
HWY_EXPORT(Facets);

void addPointVisibility(const PointLightSamples& points, const BlockerLanes& blockers,
                        const MaskReceivers& receivers, float epsilon, MaskSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddPoints)(points, blockers, receivers, epsilon, sums);
}

void facetIrradiance16(const PointLightSamples& facets, std::size_t first,
                       const MaskReceivers& receivers, float* value) {
  HWY_DYNAMIC_DISPATCH(Facets)(facets, first, receivers, value);
}

}  // namespace soffit::light
#endif
