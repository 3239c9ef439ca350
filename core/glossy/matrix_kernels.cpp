// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/glossy/matrix_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/glossy/matrix_kernels.h"
#include "core/glossy/receiver_blocks.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::glossy::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

HWY_INLINE V loadHalf(const transfer::Half* at) {
  static_assert(sizeof(transfer::Half) == sizeof(hwy::float16_t));
  const hn::Rebind<hwy::float16_t, D> half;
  return hn::PromoteTo(d, hn::LoadU(half, reinterpret_cast<const hwy::float16_t*>(at)));
}

/// Light of coefficient j and channel c for the lanes from `lane`.
template <bool Each>
HWY_INLINE V lightAt(const float* light, std::size_t n, std::size_t c, std::size_t j,
                     std::size_t lane) {
  if constexpr (Each) return hn::LoadU(d, light + (c * n + j) * kBlock + lane);
  return hn::Set(d, light[c * n + j]);
}

/// A row at a time: its three sums stay in registers while the elements stream by.
template <bool Each>
HWY_INLINE void applyGeneral(const transfer::Half* matrix, std::size_t n, const float* light,
                             float* out) {
  for (std::size_t lane = 0; lane < kBlock; lane += hn::Lanes(d)) {
    const transfer::Half* m = matrix + lane;
    for (std::size_t i = 0; i < n; ++i) {
      V r = hn::Zero(d), g = hn::Zero(d), b = hn::Zero(d);
      for (std::size_t j = 0; j < n; ++j, m += kBlock) {
        const V e = loadHalf(m);
        r = hn::MulAdd(e, lightAt<Each>(light, n, 0, j, lane), r);
        g = hn::MulAdd(e, lightAt<Each>(light, n, 1, j, lane), g);
        b = hn::MulAdd(e, lightAt<Each>(light, n, 2, j, lane), b);
      }
      hn::StoreU(r, d, out + (0 * n + i) * kBlock + lane);
      hn::StoreU(g, d, out + (1 * n + i) * kBlock + lane);
      hn::StoreU(b, d, out + (2 * n + i) * kBlock + lane);
    }
  }
}

/// Each element above the diagonal serves its row (in registers) and its column (in the nearest
/// cache): half the memory, and memory is what a set of matrices waits for.
template <bool Each>
HWY_INLINE void applySymmetric(const transfer::Half* matrix, std::size_t n, const float* light,
                               float* out) {
  alignas(64) float sums[3 * kMaxLightCoefficients * 16];
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t lane = 0; lane < kBlock; lane += lanes) {
    const transfer::Half* m = matrix + lane;
    for (std::size_t k = 0; k < 3 * n; ++k) hn::Store(hn::Zero(d), d, sums + k * lanes);
    for (std::size_t i = 0; i < n; ++i) {
      const V li[3] = {lightAt<Each>(light, n, 0, i, lane), lightAt<Each>(light, n, 1, i, lane),
                       lightAt<Each>(light, n, 2, i, lane)};
      const V e0 = loadHalf(m);
      m += kBlock;
      V row[3];
      for (std::size_t c = 0; c < 3; ++c) {
        row[c] = hn::MulAdd(e0, li[c], hn::Load(d, sums + (c * n + i) * lanes));
      }
      for (std::size_t j = i + 1; j < n; ++j, m += kBlock) {
        const V e = loadHalf(m);
        for (std::size_t c = 0; c < 3; ++c) {
          row[c] = hn::MulAdd(e, lightAt<Each>(light, n, c, j, lane), row[c]);
          float* column = sums + (c * n + j) * lanes;
          hn::Store(hn::MulAdd(e, li[c], hn::Load(d, column)), d, column);
        }
      }
      for (std::size_t c = 0; c < 3; ++c) hn::StoreU(row[c], d, out + (c * n + i) * kBlock + lane);
    }
  }
}

void ApplyMatrix(const transfer::Half* matrix, bool symmetric, std::size_t n, BlockLight light,
                 float* out) {
  if (symmetric) {
    light.each ? applySymmetric<true>(matrix, n, light.values, out)
               : applySymmetric<false>(matrix, n, light.values, out);
  } else {
    light.each ? applyGeneral<true>(matrix, n, light.values, out)
               : applyGeneral<false>(matrix, n, light.values, out);
  }
}

/// Rows first .. first + Rows: each number of the receivers is read and widened once for all of
/// them, whose sums stay in registers.
template <std::size_t Rows>
HWY_INLINE void multiplyRows(const float* matrix, std::size_t first, std::size_t columns,
                             const transfer::Half* in, float* out) {
  for (std::size_t lane = 0; lane < kBlock; lane += hn::Lanes(d)) {
    V sum[Rows];
    for (V& v : sum) v = hn::Zero(d);
    for (std::size_t k = 0; k < columns; ++k) {
      const V x = loadHalf(in + k * kBlock + lane);
      for (std::size_t a = 0; a < Rows; ++a) {
        sum[a] = hn::MulAdd(hn::Set(d, matrix[(first + a) * columns + k]), x, sum[a]);
      }
    }
    for (std::size_t a = 0; a < Rows; ++a) {
      hn::StoreU(sum[a], d, out + (first + a) * kBlock + lane);
    }
  }
}

void MultiplyRows(const float* matrix, std::size_t rows, std::size_t columns,
                  const transfer::Half* in, float* out) {
  std::size_t i = 0;
  for (; i + 8 <= rows; i += 8) multiplyRows<8>(matrix, i, columns, in, out);
  for (; i + 3 <= rows; i += 3) multiplyRows<3>(matrix, i, columns, in, out);
  for (; i < rows; ++i) multiplyRows<1>(matrix, i, columns, in, out);
}

void Dot(const float* basis, const float* arriving, std::size_t n, float* radiance) {
  for (std::size_t lane = 0; lane < kBlock; lane += hn::Lanes(d)) {
    for (std::size_t c = 0; c < 3; ++c) {
      V sum = hn::Zero(d);
      for (std::size_t i = 0; i < n; ++i) {
        sum = hn::MulAdd(hn::LoadU(d, basis + i * kBlock + lane),
                         hn::LoadU(d, arriving + (c * n + i) * kBlock + lane), sum);
      }
      hn::StoreU(sum, d, radiance + c * kBlock + lane);
    }
  }
}

}  // namespace soffit::glossy::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::glossy {

HWY_EXPORT(ApplyMatrix);
HWY_EXPORT(MultiplyRows);
HWY_EXPORT(Dot);

void applyMatrixBlock(const transfer::Half* matrix, bool symmetric, std::size_t n, BlockLight light,
                      float* arriving) {
  HWY_DYNAMIC_DISPATCH(ApplyMatrix)(matrix, symmetric, n, light, arriving);
}

void multiplyBlock(const float* matrix, std::size_t rows, std::size_t columns,
                   const transfer::Half* in, float* out) {
  HWY_DYNAMIC_DISPATCH(MultiplyRows)(matrix, rows, columns, in, out);
}

void dotBlock(const float* scaled_basis, const float* arriving, std::size_t n, float* radiance) {
  HWY_DYNAMIC_DISPATCH(Dot)(scaled_basis, arriving, n, radiance);
}

}  // namespace soffit::glossy
#endif
