// SPDX-License-Identifier: MIT
#include "core/sh/triple_product.h"

#include "core/math/quadrature.h"
#include "core/math/vec.h"
#include "core/sh/basis.h"
#include "core/sh/triple_kernel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>

namespace soffit::sh {
namespace {

/// Do the orders of three trigonometric functions (cos m phi; sin |m| phi for m < 0) add up to one
/// that does not vanish over the circle?
bool ordersAddUp(int a, int b, int c) {
  const int sines = (a < 0) + (b < 0) + (c < 0);
  if (sines % 2 == 1) return false;
  const int x = std::abs(a), y = std::abs(b), z = std::abs(c);
  return x == y + z || y == x + z || z == x + y;
}

/// integral over the circle of the product of three of them; zero was sorted out before.
double circleIntegral(int a, int b, int c) {
  const auto trig = [](int m, double phi) {
    return m < 0 ? std::sin(-m * phi) : std::cos(m * phi);
  };
  constexpr int kPoints = 3 * kMaxBands;  // more than the highest frequency, 3 (kMaxBands - 1)
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double phi = 2.0 * kPi * i / kPoints;
    sum += trig(a, phi) * trig(b, phi) * trig(c, phi);
  }
  return sum * 2.0 * kPi / kPoints;
}

bool isTriangle(int a, int b, int c) {
  return (a + b + c) % 2 == 0 && a <= b + c && b <= a + c && c <= a + b;
}

/// The basis on the meridian phi = 0, where y_{l,m} is its factor in theta; at the nodes of a rule.
struct Meridian {
  QuadratureRule rule;
  std::vector<std::array<double, kMaxCoefficients>> values;

  explicit Meridian(int bands) : rule(gaussLegendre(3 * bands / 2 + 1)) {
    for (const double z : rule.nodes) {
      evaluate(dvec3(std::sqrt((1.0 - z) * (1.0 + z)), 0.0, z), bands, values.emplace_back());
    }
  }
  /// integral over z of three factors.
  [[nodiscard]] double integral(std::size_t i, std::size_t j, std::size_t k) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
      sum += rule.weights[n] * values[n][i] * values[n][j] * values[n][k];
    }
    return sum;
  }
};

/// y_{l,|m|} has the same factor in theta as y_{l,m}.
std::size_t cosineOf(std::size_t i) {
  return index(degreeOf(i), std::abs(orderOf(i)));
}

template <class Real>
void multiplyEntries(std::span<const TripleEntry> entries, std::span<const Real> a,
                     std::span<const Real> b, std::span<Real> c) {
  std::fill(c.begin(), c.end(), Real(0));
  for (const TripleEntry& e : entries) {
    const auto v = static_cast<Real>(e.value);
    const std::size_t i = e.i, j = e.j, k = e.k;
    if (i != j && j != k) {
      c[k] += v * (a[i] * b[j] + a[j] * b[i]);
      c[j] += v * (a[i] * b[k] + a[k] * b[i]);
      c[i] += v * (a[j] * b[k] + a[k] * b[j]);
    } else if (i == k) {
      c[i] += v * a[i] * b[i];
    } else {
      // One index stands alone, the other twice.
      const std::size_t twice = j;
      const std::size_t once = i == j ? k : i;
      c[once] += v * a[twice] * b[twice];
      c[twice] += v * (a[once] * b[twice] + a[twice] * b[once]);
    }
  }
}

}  // namespace

TripleProduct::TripleProduct(int bands) : bands_(bands) {
  const Meridian meridian(bands);
  const std::size_t count = coefficientCount(bands);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      for (std::size_t k = j; k < count; ++k) {
        if (!isTriangle(degreeOf(i), degreeOf(j), degreeOf(k)) ||
            !ordersAddUp(orderOf(i), orderOf(j), orderOf(k))) {
          continue;
        }
        const double around = circleIntegral(orderOf(i), orderOf(j), orderOf(k));
        const double value = around * meridian.integral(cosineOf(i), cosineOf(j), cosineOf(k));
        entries_.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                            static_cast<std::uint16_t>(k), value});
      }
    }
  }
}

const TripleProduct& TripleProduct::ofBands(int bands) {
  assert(bands >= 1 && bands <= kMaxBands);
  static std::array<std::once_flag, kMaxBands> once;
  static std::array<std::unique_ptr<const TripleProduct>, kMaxBands> made;
  const auto at = static_cast<std::size_t>(bands - 1);
  std::call_once(once[at], [&] { made[at].reset(new TripleProduct(bands)); });
  return *made[at];
}

double TripleProduct::at(std::size_t i, std::size_t j, std::size_t k) const {
  std::array<std::size_t, 3> key{i, j, k};
  std::sort(key.begin(), key.end());
  const auto before = [](const TripleEntry& e, const std::array<std::size_t, 3>& s) {
    return std::array<std::size_t, 3>{e.i, e.j, e.k} < s;
  };
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), key, before);
  if (found == entries_.end() || found->i != key[0] || found->j != key[1] || found->k != key[2]) {
    return 0.0;
  }
  return found->value;
}

void TripleProduct::multiply(std::span<const double> a, std::span<const double> b,
                             std::span<double> c) const {
  multiplyEntries<double>(entries_, a, b, c);
}

void TripleProduct::multiply(std::span<const float> a, std::span<const float> b,
                             std::span<float> c) const {
  multiplyEntries<float>(entries_, a, b, c);
}

void TripleProduct::multiplyBatch(const float* a, const float* b, float* c, std::size_t n,
                                  std::size_t stride) const {
  assert(n <= stride);
  multiplyBatchKernel(entries_, coefficientCount(bands_), a, b, c, n, stride);
}

std::vector<double> TripleProduct::matrixOf(std::span<const double> f) const {
  const std::size_t n = coefficientCount(bands_);
  assert(f.size() == n);
  std::vector<double> matrix(n * n, 0.0);
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    matrix[row * n + column] += value;
    if (row != column) matrix[column * n + row] += value;
  };
  for (const TripleEntry& e : entries_) {
    add(e.j, e.k, f[e.i] * e.value);
    if (e.j != e.i) add(e.i, e.k, f[e.j] * e.value);
    if (e.k != e.j) add(e.i, e.j, f[e.k] * e.value);
  }
  return matrix;
}

void multiplyByMatrix(std::span<const float> matrix, std::span<const float> b, std::span<float> c) {
  assert(matrix.size() == b.size() * c.size());
  // Column by column: the additions to c are independent of one another (and the compiler's own
  // vectors serve). M is symmetric, so its rows are its columns.
  std::fill(c.begin(), c.end(), 0.0F);
  for (std::size_t j = 0; j < b.size(); ++j) {
    const float* column = matrix.data() + j * c.size();
    for (std::size_t k = 0; k < c.size(); ++k) c[k] += column[k] * b[j];
  }
}

double innerProduct(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace soffit::sh
