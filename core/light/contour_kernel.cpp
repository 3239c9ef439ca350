// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/contour_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <span>

#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Contour(std::span<const dvec3> outline, const MaskReceivers& r, double* value,
             std::uint32_t& clipped) {
  using DD = hn::CappedTag<double, 8>;
  constexpr DD dd;
  using VD = hn::Vec<DD>;
  struct VD3 {
    VD x, y, z;
  };
  clipped = 0;
  const auto load = [&](const float* from, std::size_t lane) {
    const hn::Rebind<float, DD> df;
    return hn::PromoteTo(dd, hn::LoadU(df, from + lane));
  };
  const auto dot3 = [](const VD3& a, const VD3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
  };
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(dd)) {
    const VD3 p{load(r.x, lane), load(r.y, lane), load(r.z, lane)};
    const VD3 n{load(r.nx, lane), load(r.ny, lane), load(r.nz, lane)};
    const auto relative = [&](const dvec3& c) {
      return VD3{hn::Sub(hn::Set(dd, c.x), p.x), hn::Sub(hn::Set(dd, c.y), p.y),
                 hn::Sub(hn::Set(dd, c.z), p.z)};
    };
    VD3 a = relative(outline.back());
    VD length_a = hn::Sqrt(dot3(a, a));
    VD sum = hn::Zero(dd);
    VD lowest = hn::Set(dd, 1e300);
    VD highest = hn::Set(dd, -1e300);
    for (const dvec3& corner : outline) {
      const VD3 b = relative(corner);
      const VD length_b = hn::Sqrt(dot3(b, b));
      const VD height = dot3(n, b);
      lowest = hn::Min(lowest, height);
      highest = hn::Max(highest, height);
      const VD3 c{hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)),
                  hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
                  hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
      const VD s = hn::Sqrt(dot3(c, c));
      // tan(g/2) = s / (|a||b| + a.b); s = 0 contributes nothing.
      const VD t = hn::Div(s, hn::MulAdd(length_a, length_b, dot3(a, b)));
      const VD g = hn::Mul(hn::Set(dd, 2.0), hn::Atan(dd, t));
      const VD term = hn::Div(hn::Mul(g, dot3(n, c)), s);
      sum = hn::Sub(sum, hn::IfThenElseZero(hn::Gt(s, hn::Zero(dd)), term));
      a = b;
      length_a = length_b;
    }
    const VD e = hn::IfThenElseZero(hn::Gt(highest, hn::Zero(dd)),
                                    hn::Max(hn::Mul(sum, hn::Set(dd, 0.5)), hn::Zero(dd)));
    hn::StoreU(e, dd, value + lane);
    const auto cut = hn::And(hn::Le(lowest, hn::Zero(dd)), hn::Gt(highest, hn::Zero(dd)));
    double flags[8];
    hn::StoreU(hn::IfThenElseZero(cut, hn::Set(dd, 1.0)), dd, flags);
    for (std::size_t i = 0; i < hn::Lanes(dd); ++i) {
      if (flags[i] != 0.0) clipped |= 1U << (lane + i);
    }
  }
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(Contour);

void contourIrradiance16(std::span<const dvec3> outline, const MaskReceivers& receivers,
                         double* value, std::uint32_t& clipped) {
  HWY_DYNAMIC_DISPATCH(Contour)(outline, receivers, value, clipped);
}

}  // namespace soffit::light
#endif
