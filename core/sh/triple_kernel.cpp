// SPDX-License-Identifier: MIT
// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sh/triple_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>
#include <cassert>

#include "core/sh/triple_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace soffit::sh::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

/// The items of one vector side by side, [coefficient][lane], so that all three operands stay in
/// the first-level cache: 3 x 100 x 16 floats at most.
struct Strip {
  alignas(64) float a[kMaxCoefficients][16];
  alignas(64) float b[kMaxCoefficients][16];
  alignas(64) float c[kMaxCoefficients][16];
};

HWY_INLINE void multiplyStrip(std::span<const TripleEntry> entries, Strip& s) {
  const auto product = [&s](std::size_t i, std::size_t j)
                           HWY_ATTR { return hn::Mul(hn::Load(d, s.a[i]), hn::Load(d, s.b[j])); };
  const auto both = [&s, &product](std::size_t i, std::size_t j) HWY_ATTR {
    return hn::MulAdd(hn::Load(d, s.a[j]), hn::Load(d, s.b[i]), product(i, j));
  };
  const auto add = [&s](std::size_t k, const V v, const V value) HWY_ATTR {
    hn::Store(hn::MulAdd(v, value, hn::Load(d, s.c[k])), d, s.c[k]);
  };
  for (const TripleEntry& e : entries) {
    const V v = hn::Set(d, static_cast<float>(e.value));
    const std::size_t i = e.i, j = e.j, k = e.k;
    if (i != j && j != k) {
      add(k, v, both(i, j));
      add(j, v, both(i, k));
      add(i, v, both(j, k));
    } else if (i == k) {
      add(i, v, product(i, i));
    } else {
      const std::size_t once = i == j ? k : i;
      add(once, v, product(j, j));
      add(j, v, both(once, j));
    }
  }
}

/// One row of a strip; lanes beyond `used` are 0.
HWY_INLINE void loadRow(const float* from, std::size_t used, float* row) {
  if (used >= hn::Lanes(d)) {
    hn::Store(hn::LoadU(d, from), d, row);
  } else {
    hn::Store(hn::Zero(d), d, row);
    std::copy(from, from + used, row);
  }
}

HWY_INLINE void storeRow(const float* row, std::size_t used, float* to) {
  if (used >= hn::Lanes(d)) {
    hn::StoreU(hn::Load(d, row), d, to);
  } else {
    std::copy(row, row + used, to);
  }
}

void Multiply(std::span<const TripleEntry> entries, std::size_t coefficients, const float* a,
              const float* b, float* c, std::size_t n, std::size_t stride) {
  const std::size_t lanes = hn::Lanes(d);
  Strip s;
  for (std::size_t begin = 0; begin < n; begin += lanes) {
    const std::size_t used = std::min(lanes, n - begin);
    for (std::size_t i = 0; i < coefficients; ++i) {
      loadRow(a + i * stride + begin, used, s.a[i]);
      loadRow(b + i * stride + begin, used, s.b[i]);
      hn::Store(hn::Zero(d), d, s.c[i]);
    }
    multiplyStrip(entries, s);
    for (std::size_t i = 0; i < coefficients; ++i) {
      storeRow(s.c[i], used, c + i * stride + begin);
    }
  }
}

/// Four rows of the matrix at a time share the loads of b.
HWY_INLINE void matrixStrip(const float* matrix, std::size_t size, Strip& s) {
  for (std::size_t row = 0; row < size; row += 4) {
    const std::size_t rows = std::min<std::size_t>(4, size - row);
    const float* m[4];
    for (std::size_t q = 0; q < 4; ++q) m[q] = matrix + (row + std::min(q, rows - 1)) * size;
    V sum0 = hn::Zero(d), sum1 = hn::Zero(d), sum2 = hn::Zero(d), sum3 = hn::Zero(d);
    for (std::size_t j = 0; j < size; ++j) {
      const V b = hn::Load(d, s.b[j]);
      sum0 = hn::MulAdd(hn::Set(d, m[0][j]), b, sum0);
      sum1 = hn::MulAdd(hn::Set(d, m[1][j]), b, sum1);
      sum2 = hn::MulAdd(hn::Set(d, m[2][j]), b, sum2);
      sum3 = hn::MulAdd(hn::Set(d, m[3][j]), b, sum3);
    }
    hn::Store(sum0, d, s.c[row]);
    if (rows > 1) hn::Store(sum1, d, s.c[row + 1]);
    if (rows > 2) hn::Store(sum2, d, s.c[row + 2]);
    if (rows > 3) hn::Store(sum3, d, s.c[row + 3]);
  }
}

void MultiplyByMatrix(const float* matrix, std::size_t coefficients, const float* b, float* c,
                      std::size_t n, std::size_t stride) {
  const std::size_t lanes = hn::Lanes(d);
  Strip s;
  for (std::size_t begin = 0; begin < n; begin += lanes) {
    const std::size_t used = std::min(lanes, n - begin);
    for (std::size_t i = 0; i < coefficients; ++i) loadRow(b + i * stride + begin, used, s.b[i]);
    matrixStrip(matrix, coefficients, s);
    for (std::size_t i = 0; i < coefficients; ++i) {
      storeRow(s.c[i], used, c + i * stride + begin);
    }
  }
}

}  // namespace soffit::sh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::sh {

HWY_EXPORT(Multiply);
HWY_EXPORT(MultiplyByMatrix);

void multiplyBatchKernel(std::span<const TripleEntry> entries, std::size_t coefficients,
                         const float* a, const float* b, float* c, std::size_t n,
                         std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(Multiply)(entries, coefficients, a, b, c, n, stride);
}

void multiplyByMatrixBatch(std::span<const float> matrix, std::size_t coefficients, const float* b,
                           float* c, std::size_t n, std::size_t stride) {
  assert(matrix.size() == coefficients * coefficients && n <= stride);
  assert(coefficients <= kMaxCoefficients);
  HWY_DYNAMIC_DISPATCH(MultiplyByMatrix)(matrix.data(), coefficients, b, c, n, stride);
}

}  // namespace soffit::sh
#endif
