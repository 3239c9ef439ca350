// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/point_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>
#include <span>

#include "core/light/lanes-inl.h"
#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {

/// Half-spaces through p and a blocker's edges, and beyond its plane, for the point form.
struct ConePlanes {
  V3 m[6];
  V c[6];
  int count;
};

HWY_INLINE ConePlanes conePlanes(const MaskBlocker& blocker, const V3& p, const Facing& side) {
  ConePlanes planes;
  planes.count = blocker.count + 1;
  for (int k = 0; k < blocker.count; ++k) {
    const vec3& q = blocker.corners[static_cast<std::size_t>(k)];
    const vec3& next = blocker.corners[static_cast<std::size_t>((k + 1) % blocker.count)];
    V3 m = cross(sub(set3(q), p), set3(next - q));
    m = {hn::Mul(m.x, side.sign), hn::Mul(m.y, side.sign), hn::Mul(m.z, side.sign)};
    planes.m[k] = m;
    planes.c[k] = hn::Neg(dot(m, p));
  }
  const V3 n = set3(blocker.normal);
  planes.m[blocker.count] = {hn::Mul(n.x, side.sign), hn::Mul(n.y, side.sign),
                             hn::Mul(n.z, side.sign)};
  planes.c[blocker.count] = hn::Neg(hn::Mul(side.sign, hn::Set(d, blocker.d)));
  return planes;
}

void AddPoints(const PointLightSamples& points, std::span<const MaskBlocker* const> blockers,
               const MaskReceivers& r, float epsilon, MaskSums& sums) {
  constexpr std::size_t kBlock = 128;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const V3 p{hn::LoadU(d, r.x + lane), hn::LoadU(d, r.y + lane), hn::LoadU(d, r.z + lane)};
    const V3 n{hn::LoadU(d, r.nx + lane), hn::LoadU(d, r.ny + lane), hn::LoadU(d, r.nz + lane)};
    const M asked = lanesOf(r.lanes, lane);
    if (hn::AllFalse(d, asked)) continue;
    V visible = hn::Zero(d);
    V total = hn::Zero(d);
    V plain = hn::Zero(d);
    float plain_total = 0.0F;
    for (std::size_t start = 0; start < points.size(); start += kBlock) {
      const std::size_t end = std::min(points.size(), start + kBlock);
      VU hidden[kBlock / 32];
      for (auto& word : hidden) word = hn::Zero(du);
      for (const MaskBlocker* const one : blockers) {
        const MaskBlocker& blocker = *one;
        Facing side = facing(blocker, p, epsilon);
        side.active = hn::And(side.active, asked);
        if (hn::AllFalse(d, side.active)) continue;
        const ConePlanes planes = conePlanes(blocker, p, side);
        for (std::size_t k = start; k < end; ++k) {
          const V3 x{hn::Set(d, points.x[k]), hn::Set(d, points.y[k]), hn::Set(d, points.z[k])};
          V least = hn::Add(dot(planes.m[0], x), planes.c[0]);
          for (int e = 1; e < planes.count; ++e) {
            least = hn::Min(least, hn::Add(dot(planes.m[e], x), planes.c[e]));
          }
          const M inside = hn::And(side.active, hn::Gt(least, hn::Zero(d)));
          const std::size_t bit = k - start;
          hidden[bit / 32] =
              hn::Or(hidden[bit / 32],
                     hn::IfThenElseZero(hn::RebindMask(du, inside), hn::Set(du, 1U << (bit % 32))));
        }
      }
      for (std::size_t k = start; k < end; ++k) {
        const std::size_t bit = k - start;
        const V3 x{hn::Set(d, points.x[k]), hn::Set(d, points.y[k]), hn::Set(d, points.z[k])};
        const V3 to = sub(x, p);
        const V r2 = dot(to, to);
        const V cos_p = hn::Max(dot(n, to), hn::Zero(d));
        V weight;
        if (points.nx[k] == 0.0F && points.ny[k] == 0.0F && points.nz[k] == 0.0F) {
          weight = hn::Div(cos_p, hn::Max(hn::Mul(r2, hn::Sqrt(r2)), hn::Set(d, 1e-30F)));
        } else {
          const V3 m{hn::Set(d, points.nx[k]), hn::Set(d, points.ny[k]), hn::Set(d, points.nz[k])};
          const V cos_l = hn::Max(hn::Neg(dot(m, to)), hn::Zero(d));
          weight = hn::Div(hn::Mul(cos_p, cos_l), hn::Max(hn::Mul(r2, r2), hn::Set(d, 1e-30F)));
        }
        weight = hn::Mul(weight, hn::Set(d, points.weight[k]));
        const VU one = hn::Set(du, 1U << (bit % 32));
        const auto seen = hn::RebindMask(d, hn::Eq(hn::And(hidden[bit / 32], one), hn::Zero(du)));
        visible = hn::Add(visible, hn::IfThenElseZero(seen, weight));
        total = hn::Add(total, weight);
        plain = hn::Add(plain, hn::IfThenElseZero(seen, hn::Set(d, points.weight[k])));
        plain_total += points.weight[k];
      }
    }
    addToSums(lane, visible, total, plain, plain_total, sums);
  }
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(AddPoints);

void addPointVisibility(const PointLightSamples& points,
                        std::span<const MaskBlocker* const> blockers,
                        const MaskReceivers& receivers, float epsilon, MaskSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddPoints)(points, blockers, receivers, epsilon, sums);
}

}  // namespace soffit::light
#endif
