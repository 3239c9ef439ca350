// SPDX-License-Identifier: MIT
// Four floats (RGB + padding) as one vector, on every Highway target: the scalar one has no vectors
// of four. Included once per target, like Highway's own headers of this kind, and after them.
#if defined(SOFFIT_CORE_TRANSFER_RGB_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SOFFIT_CORE_TRANSFER_RGB_LANES_INL_H
#undef SOFFIT_CORE_TRANSFER_RGB_LANES_INL_H
#else
#define SOFFIT_CORE_TRANSFER_RGB_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace soffit::transfer::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
struct Rgb {
  float v[4] = {0.0F, 0.0F, 0.0F, 0.0F};
};
inline Rgb zeroRgb() { return {}; }
inline Rgb loadRgb(const float* from) { return {{from[0], from[1], from[2], from[3]}}; }
inline void storeRgb(const Rgb& a, float* to) {
  for (int c = 0; c < 4; ++c) to[c] = a.v[c];
}
inline Rgb addRgb(Rgb a, const Rgb& b) {
  for (int c = 0; c < 4; ++c) a.v[c] += b.v[c];
  return a;
}
/// s a + b.
inline Rgb mulAddRgb(float s, const Rgb& a, Rgb b) {
  for (int c = 0; c < 4; ++c) b.v[c] += s * a.v[c];
  return b;
}
#else
using Rgb4 = hwy::HWY_NAMESPACE::FixedTag<float, 4>;
using Rgb = hwy::HWY_NAMESPACE::Vec<Rgb4>;
HWY_INLINE Rgb zeroRgb() { return hwy::HWY_NAMESPACE::Zero(Rgb4()); }
HWY_INLINE Rgb loadRgb(const float* from) { return hwy::HWY_NAMESPACE::LoadU(Rgb4(), from); }
HWY_INLINE void storeRgb(Rgb a, float* to) { hwy::HWY_NAMESPACE::StoreU(a, Rgb4(), to); }
HWY_INLINE Rgb addRgb(Rgb a, Rgb b) { return hwy::HWY_NAMESPACE::Add(a, b); }
/// s a + b.
HWY_INLINE Rgb mulAddRgb(float s, Rgb a, Rgb b) {
  return hwy::HWY_NAMESPACE::MulAdd(hwy::HWY_NAMESPACE::Set(Rgb4(), s), a, b);
}
#endif

}  // namespace soffit::transfer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
