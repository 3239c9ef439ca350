// SPDX-License-Identifier: MIT
#include "core/glossy/matrix_set.h"

#include "core/glossy/lobe_shape.h"
#include "core/glossy/transfer_matrix.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

/// Half precision: 2^-11 an element; sums of n elements of size below 1 by light of size below 1.
double tolerance(std::size_t n) {
  return static_cast<double>(n) * 0x1p-11;
}

struct Case {
  int bands;
  std::size_t receivers;
  std::vector<std::vector<double>> matrices;
  sh::RgbCoefficients light;
};

Case randomCase(int bands, std::size_t receivers, bool symmetric) {
  Rng rng(static_cast<std::uint64_t>(bands) * 100 + receivers);
  const std::size_t n = sh::coefficientCount(bands);
  Case c{bands, receivers, {}, {}};
  for (std::size_t r = 0; r < receivers; ++r) {
    std::vector<double> m(n * n);
    for (double& x : m) x = 2.0 * rng.uniformDouble() - 1.0;
    for (std::size_t i = 0; i < n && symmetric; ++i) {
      for (std::size_t j = 0; j < i; ++j) m[i * n + j] = m[j * n + i];
    }
    c.matrices.push_back(m);
  }
  for (auto& channel : c.light) {
    for (std::size_t i = 0; i < n; ++i) channel.push_back(2.0 * rng.uniformDouble() - 1.0);
  }
  return c;
}

double product(const std::vector<double>& matrix, std::size_t row, const sh::Coefficients& light) {
  double sum = 0.0;
  for (std::size_t j = 0; j < light.size(); ++j) sum += matrix[row * light.size() + j] * light[j];
  return sum;
}

class MatrixSetCases : public testing::TestWithParam<std::tuple<int, std::size_t, bool>> {};

TEST_P(MatrixSetCases, ApplyEqualsTheProductInDoublePrecision) {
  const auto [bands, receivers, symmetric] = GetParam();
  const Case c = randomCase(bands, receivers, symmetric);
  const std::size_t n = sh::coefficientCount(bands);
  MatrixSet set(receivers, bands, symmetric);
  FloatBlocks own(receivers, 3 * n);
  for (std::size_t r = 0; r < receivers; ++r) {
    set.set(r, c.matrices[r]);
    for (std::size_t k = 0; k < 3 * n; ++k) {
      // Light of its own: the common one times a factor.
      own.at(r, k) = static_cast<float>(c.light[k / n][k % n] * (1.0 + static_cast<double>(r)));
    }
  }
  FloatBlocks one(receivers, 3 * n), each(receivers, 3 * n);
  set.apply(c.light, one);
  set.apply(own, each);
  for (std::size_t r = 0; r < receivers; ++r) {
    for (std::size_t k = 0; k < 3 * n; ++k) {
      const double exact = product(c.matrices[r], k % n, c.light[k / n]);
      const double factor = 1.0 + static_cast<double>(r);
      EXPECT_NEAR(static_cast<double>(one.at(r, k)), exact, tolerance(n));
      EXPECT_NEAR(static_cast<double>(each.at(r, k)), factor * exact, factor * tolerance(n));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, MatrixSetCases,
                         testing::Combine(testing::Values(1, 3, 4, 5, 6),
                                          testing::Values(std::size_t{1}, std::size_t{16},
                                                          std::size_t{37}),
                                          testing::Bool()));

TEST(MatrixSet, ElementsAreWhereTheyWerePut) {
  const Case c = randomCase(3, 20, true);
  MatrixSet set(20, 3, true);
  for (std::size_t r = 0; r < 20; ++r) set.set(r, c.matrices[r]);
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      EXPECT_NEAR(static_cast<double>(set.element(17, i, j)), c.matrices[17][i * 9 + j], 0x1p-11);
    }
  }
  // 20 receivers fill two blocks of 16; 45 of 81 elements of two bytes.
  EXPECT_EQ(set.bytes(), 2U * 16U * 45U * 2U);
}

TEST(MatrixSet, AnEmptySetIsLegal) {
  MatrixSet set(0, 5, true);
  FloatBlocks arriving(0, 75);
  set.apply({sh::Coefficients(25), sh::Coefficients(25), sh::Coefficients(25)}, arriving);
  shade(arriving, {}, {});
  EXPECT_EQ(set.bytes(), 0U);
}

TEST(VisibilitySet, FixedLightMatrixEqualsTheMatrices) {
  Rng rng(4);
  for (const int bands : {1, 3, 5}) {
    const std::size_t n = sh::coefficientCount(bands);
    const int wide = 2 * bands - 1;
    VisibilitySet visibility(21, wide);
    MatrixSet matrices(21, bands, true);
    for (std::size_t r = 0; r < 21; ++r) {
      sh::Coefficients v(sh::coefficientCount(wide));
      for (double& x : v) x = 2.0 * rng.uniformDouble() - 1.0;
      visibility.set(r, v);
      matrices.set(r, matrixFromVisibility(v, bands));
    }
    sh::RgbCoefficients light;
    for (auto& channel : light) {
      for (std::size_t i = 0; i < n; ++i) channel.push_back(2.0 * rng.uniformDouble() - 1.0);
    }
    FloatBlocks a(21, 3 * n), b(21, 3 * n);
    visibility.apply(light, a);
    matrices.apply(light, b);
    for (std::size_t r = 0; r < 21; ++r) {
      for (std::size_t k = 0; k < 3 * n; ++k) {
        // Elements of M grow to about 81 / sqrt(4 pi) at the very most.
        EXPECT_NEAR(a.at(r, k), b.at(r, k), 23.0F * static_cast<float>(tolerance(n)));
      }
    }
  }
}

TEST(Shade, EqualsTheSumInDoublePrecision) {
  Rng rng(9);
  const std::size_t receivers = 19;
  FloatBlocks arriving(receivers, 75);
  std::vector<LobeView> lobes(receivers);
  for (std::size_t r = 0; r < receivers; ++r) {
    for (std::size_t k = 0; k < 75; ++k) arriving.at(r, k) = 2.0F * rng.uniform() - 1.0F;
    lobes[r] = {vec3(randomDirection(rng)), rng.uniform(), 2.0F * rng.uniform()};
  }
  std::vector<vec3> radiance(receivers);
  shade(arriving, lobes, radiance);
  for (std::size_t r = 0; r < receivers; ++r) {
    for (int c = 0; c < 3; ++c) {
      sh::Coefficients own;
      for (std::size_t i = 0; i < 25; ++i) {
        own.push_back(static_cast<double>(arriving.at(r, static_cast<std::size_t>(c) * 25 + i)));
      }
      const double exact = static_cast<double>(lobes[r].weight) *
                           glossyRadiance(own, lobeKernel(static_cast<double>(lobes[r].alpha)),
                                          dvec3(lobes[r].axis));
      EXPECT_NEAR(static_cast<double>(radiance[r][c]), exact, 1e-4);  // 25 terms in float
    }
  }
}

}  // namespace
}  // namespace soffit::glossy
