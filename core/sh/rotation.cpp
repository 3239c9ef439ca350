// SPDX-License-Identifier: MIT
#include "core/sh/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace soffit::sh {
namespace {

/// The factors u, v, w of Ivanic & Ruedenberg's table 1 (1998 form).
struct Factors {
  double u, v, w;
};

Factors factors(int l, int m, int n) {
  const double below = std::abs(n) < l ? double(l + n) * (l - n) : 2.0 * l * (2.0 * l - 1.0);
  const int size = std::abs(m);
  const double one = m == 0 ? 1.0 : 0.0;
  return {std::sqrt(double(l + m) * (l - m) / below),
          0.5 * std::sqrt((1.0 + one) * (l + size - 1.0) * (l + size) / below) * (1.0 - 2.0 * one),
          -0.5 * std::sqrt((l - size - 1.0) * (l - size) / below) * (1.0 - one)};
}

}  // namespace

Rotation::Rotation(const dmat3& matrix, int bands) : bands_(bands), elements_(offset(bands), 0.0) {
  assert(bands >= 1 && bands <= kMaxBands);
  elements_[0] = 1.0;
  // Band 1 is the matrix itself in the order y, z, x. GLM: [column][row].
  static constexpr int kAxis[3] = {1, 2, 0};
  std::vector<double> first(9);
  for (std::size_t m = 0; m < 3; ++m) {
    for (std::size_t n = 0; n < 3; ++n) first[m * 3 + n] = matrix[kAxis[n]][kAxis[m]];
  }
  if (bands > 1) std::copy(first.begin(), first.end(), elements_.begin() + 1);
  for (int l = 2; l < bands; ++l) addBand(l, first);
}

void Rotation::addBand(int l, const std::vector<double>& first) {
  const auto r = [&](int i, int j) { return first[static_cast<std::size_t>((i + 1) * 3 + j + 1)]; };
  const auto p = [&](int i, int a, int b) {
    if (b == l) return r(i, 1) * element(l - 1, a, l - 1) - r(i, -1) * element(l - 1, a, 1 - l);
    if (b == -l) return r(i, 1) * element(l - 1, a, 1 - l) + r(i, -1) * element(l - 1, a, l - 1);
    return r(i, 0) * element(l - 1, a, b);
  };
  const auto v = [&](int m, int n) {
    if (m == 0) return p(1, 1, n) + p(-1, -1, n);
    if (m > 0) {
      const double far = m == 1 ? 0.0 : p(-1, 1 - m, n);
      return p(1, m - 1, n) * (m == 1 ? std::sqrt(2.0) : 1.0) - far;
    }
    const double near = m == -1 ? 0.0 : p(1, m + 1, n);
    return near + p(-1, -m - 1, n) * (m == -1 ? std::sqrt(2.0) : 1.0);
  };
  const auto w = [&](int m, int n) {
    return m > 0 ? p(1, m + 1, n) + p(-1, -m - 1, n) : p(1, m - 1, n) - p(-1, 1 - m, n);
  };
  std::size_t at = offset(l);
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      // Factors are 0 exactly where the elements they multiply do not exist.
      const Factors f = factors(l, m, n);
      double sum = 0.0;
      if (f.u != 0.0) sum += f.u * p(0, m, n);
      if (f.v != 0.0) sum += f.v * v(m, n);
      if (f.w != 0.0) sum += f.w * w(m, n);
      elements_[at++] = sum;
    }
  }
}

Coefficients Rotation::apply(std::span<const double> coefficients) const {
  const int bands = bandsOf(coefficients.size());
  assert(bands <= bands_);
  Coefficients out(coefficients.size(), 0.0);
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      double sum = 0.0;
      for (int n = -l; n <= l; ++n) sum += element(l, m, n) * coefficients[index(l, n)];
      out[index(l, m)] = sum;
    }
  }
  return out;
}

Coefficients Rotation::applyInverse(std::span<const double> coefficients) const {
  const int bands = bandsOf(coefficients.size());
  assert(bands <= bands_);
  Coefficients out(coefficients.size(), 0.0);
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) {
        out[index(l, n)] += element(l, m, n) * coefficients[index(l, m)];
      }
    }
  }
  return out;
}

Coefficients rotateAboutZ(std::span<const double> coefficients, double angle) {
  const int bands = bandsOf(coefficients.size());
  Coefficients out(coefficients.begin(), coefficients.end());
  for (int m = 1; m < bands; ++m) {
    const double c = std::cos(m * angle);
    const double s = std::sin(m * angle);
    for (int l = m; l < bands; ++l) {
      const double cosine = coefficients[index(l, m)];
      const double sine = coefficients[index(l, -m)];
      out[index(l, m)] = c * cosine - s * sine;
      out[index(l, -m)] = s * cosine + c * sine;
    }
  }
  return out;
}

}  // namespace soffit::sh
