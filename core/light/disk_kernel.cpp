// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/light/disk_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <numbers>

#include "core/light/light_mask.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// diskIrradiance() where the whole disk is above the horizon, term by term.
void Disk(const dvec3& center, const dvec3& axis, double radius, const MaskReceivers& r,
          double* value, std::uint32_t& clipped) {
  using DD = hn::CappedTag<double, 8>;
  constexpr DD dd;
  using VD = hn::Vec<DD>;
  clipped = 0;
  const auto set = [&](double v) { return hn::Set(dd, v); };
  const auto load = [&](const float* from, std::size_t lane) {
    const hn::Rebind<float, DD> df;
    return hn::PromoteTo(dd, hn::LoadU(df, from + lane));
  };
  const VD ax = set(axis.x), ay = set(axis.y), az = set(axis.z);
  const VD a2 = set(radius * radius);
  const VD half_pi = set(0.5 * std::numbers::pi);
  const VD zero = hn::Zero(dd);
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(dd)) {
    const VD dx = hn::Sub(load(r.x, lane), set(center.x));
    const VD dy = hn::Sub(load(r.y, lane), set(center.y));
    const VD dz = hn::Sub(load(r.z, lane), set(center.z));
    const VD nx = load(r.nx, lane), ny = load(r.ny, lane), nz = load(r.nz, lane);
    const VD z = hn::MulAdd(dx, ax, hn::MulAdd(dy, ay, hn::Mul(dz, az)));
    const VD rx = hn::NegMulAdd(z, ax, dx);
    const VD ry = hn::NegMulAdd(z, ay, dy);
    const VD rz = hn::NegMulAdd(z, az, dz);
    const VD r2 = hn::MulAdd(rx, rx, hn::MulAdd(ry, ry, hn::Mul(rz, rz)));
    const VD height = hn::Neg(hn::MulAdd(nx, dx, hn::MulAdd(ny, dy, hn::Mul(nz, dz))));
    const VD cos_tilt = hn::MulAdd(nx, ax, hn::MulAdd(ny, ay, hn::Mul(nz, az)));
    const VD reach =
        hn::Mul(set(radius), hn::Sqrt(hn::Max(zero, hn::NegMulAdd(cos_tilt, cos_tilt, set(1.0)))));
    const VD s = hn::Add(hn::MulAdd(z, z, r2), a2);
    const VD q = hn::Sqrt(hn::Max(zero, hn::MulSub(s, s, hn::Mul(hn::Mul(set(4.0), a2), r2))));
    const VD s_minus_q = hn::Div(hn::Mul(hn::Mul(set(4.0), a2), r2), hn::Add(q, s));
    const VD along_axis = hn::Div(hn::Mul(half_pi, hn::MulSub(set(2.0), a2, s_minus_q)), q);
    const VD radial_factor =
        hn::Div(hn::Mul(half_pi, hn::Mul(hn::Mul(set(4.0), a2), z)), hn::Mul(q, hn::Add(q, s)));
    const VD across = hn::MulAdd(nx, rx, hn::MulAdd(ny, ry, hn::Mul(nz, rz)));
    const VD e =
        hn::Max(zero, hn::Neg(hn::MulAdd(cos_tilt, along_axis, hn::Mul(across, radial_factor))));
    const auto before = hn::And(hn::Gt(z, zero), hn::Gt(q, zero));
    hn::StoreU(hn::IfThenElseZero(hn::And(before, hn::Ge(height, reach)), e), dd, value + lane);
    const auto cut =
        hn::And(hn::Gt(z, zero), hn::And(hn::Lt(height, reach), hn::Gt(height, hn::Neg(reach))));
    double flags[8];
    hn::StoreU(hn::IfThenElseZero(cut, set(1.0)), dd, flags);
    for (std::size_t i = 0; i < hn::Lanes(dd); ++i) {
      if (flags[i] != 0.0) clipped |= 1U << (lane + i);
    }
  }
}

}  // namespace soffit::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::light {

HWY_EXPORT(Disk);

void diskIrradiance16(const dvec3& center, const dvec3& axis, double radius,
                      const MaskReceivers& receivers, double* value, std::uint32_t& clipped) {
  HWY_DYNAMIC_DISPATCH(Disk)(center, axis, radius, receivers, value, clipped);
}

}  // namespace soffit::light
#endif
