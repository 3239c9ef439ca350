// SPDX-License-Identifier: MIT
#include "core/sh/triple_product.h"

#include "core/sh/basis.h"
#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::sh {
namespace {

TEST(TripleProduct, MatchesQuadratureElementByElement) {
  // All elements of 4 bands, and every 97th of 10.
  for (const int bands : {4, 10}) {
    const TripleProduct& tensor = TripleProduct::ofBands(bands);
    const SphereSamples rule = cubature(3 * (bands - 1));
    std::vector<std::array<double, kMaxCoefficients>> y(rule.size());
    for (std::size_t k = 0; k < rule.size(); ++k) evaluate(rule.directions[k], bands, y[k]);
    const std::size_t n = coefficientCount(bands);
    const std::size_t step = bands == 4 ? 1 : 97;
    for (std::size_t e = 0; e < n * n * n; e += step) {
      const std::size_t i = e / (n * n), j = e / n % n, k = e % n;
      double sum = 0.0;
      for (std::size_t s = 0; s < rule.size(); ++s)
        sum += rule.weights[s] * y[s][i] * y[s][j] * y[s][k];
      ASSERT_NEAR(tensor.at(i, j, k), sum, 400 * kEps) << i << " " << j << " " << k;
    }
  }
}

TEST(TripleProduct, IsSymmetricAndSparse) {
  const TripleProduct& tensor = TripleProduct::ofBands(5);
  for (const TripleEntry& e : tensor.entries()) {
    EXPECT_LE(e.i, e.j);
    EXPECT_LE(e.j, e.k);
    EXPECT_EQ(tensor.at(e.k, e.i, e.j), e.value);
    EXPECT_EQ(tensor.at(e.j, e.k, e.i), e.value);
  }
  EXPECT_EQ(tensor.at(1, 0, 0), 0.0);
  // Of 25 x 26 x 27 / 6 = 2925 different elements at 5 bands less than an eighth are not 0.
  EXPECT_LT(tensor.entries().size(), 2925U / 8U);
  EXPECT_LT(TripleProduct::ofBands(10).entries().size(), 171700U / 16U);
}

TEST(TripleProduct, FirstIndexIsTheConstantFunction) {
  const TripleProduct& tensor = TripleProduct::ofBands(6);
  for (std::size_t i = 0; i < 36; ++i) {
    for (std::size_t j = 0; j < 36; ++j) {
      EXPECT_NEAR(tensor.at(0, i, j), i == j ? 0.5 / std::sqrt(kPi) : 0.0, 64 * kEps);
    }
  }
}

TEST(TripleProduct, MultipliesFunctionsExactlyBelowTheCutOff) {
  Rng rng(71);
  // Two functions of 5 bands have a product of 9, all of which 10 bands hold.
  Coefficients a = randomCoefficients(5, rng), b = randomCoefficients(5, rng);
  a.resize(100, 0.0);
  b.resize(100, 0.0);
  Coefficients c(100);
  TripleProduct::ofBands(10).multiply(a, b, c);
  for (const dvec3& d : testDirections(50, 72)) {
    EXPECT_NEAR(reconstruct(c, d), reconstruct(a, d) * reconstruct(b, d), 1e-12);
  }
}

TEST(TripleProduct, EqualsTheProjectedProductAndCommutes) {
  Rng rng(73);
  for (int bands = 1; bands <= kMaxBands; ++bands) {
    const Coefficients a = randomCoefficients(bands, rng), b = randomCoefficients(bands, rng);
    const auto product = [&](const dvec3& d) { return reconstruct(a, d) * reconstruct(b, d); };
    Coefficients ab(a.size()), ba(a.size());
    const TripleProduct& tensor = TripleProduct::ofBands(bands);
    tensor.multiply(a, b, ab);
    tensor.multiply(b, a, ba);
    EXPECT_LE(largestDifference(ab, project(product, cubature(3 * (bands - 1)), bands)), 1e-11);
    EXPECT_LE(largestDifference(ab, ba), 1e-13);
  }
}

TEST(TripleProduct, FixedLightMatrixIsTheContraction) {
  Rng rng(74);
  for (const int bands : {1, 2, 5, 10}) {
    const TripleProduct& tensor = TripleProduct::ofBands(bands);
    const Coefficients light = randomCoefficients(bands, rng), b = randomCoefficients(bands, rng);
    const std::vector<double> matrix = tensor.matrixOf(light);
    Coefficients direct(b.size());
    tensor.multiply(light, b, direct);
    const std::size_t n = b.size();
    std::vector<float> single(matrix.begin(), matrix.end());
    std::vector<float> b_single(b.begin(), b.end()), c_single(n);
    multiplyByMatrix(single, b_single, c_single);
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0.0;
      for (std::size_t j = 0; j < n; ++j) {
        sum += matrix[k * n + j] * b[j];
        EXPECT_EQ(matrix[k * n + j], matrix[j * n + k]);
      }
      EXPECT_NEAR(sum, direct[k], 1e-12);
      EXPECT_NEAR(c_single[k], direct[k], 1e-4);  // 100 products of single precision, sums to 30
    }
  }
}

TEST(TripleProduct, BatchEqualsOneByOne) {
  Rng rng(75);
  for (const int bands : {2, 5, 10}) {
    const TripleProduct& tensor = TripleProduct::ofBands(bands);
    const std::size_t n = 21, stride = 23, count = coefficientCount(bands);
    std::vector<float> a(count * stride), b(count * stride), c(count * stride, 9.0F);
    for (float& v : a) v = 2.0F * rng.uniform() - 1.0F;
    for (float& v : b) v = 2.0F * rng.uniform() - 1.0F;
    tensor.multiplyBatch(a.data(), b.data(), c.data(), n, stride);
    for (std::size_t item = 0; item < n; ++item) {
      std::vector<float> one_a(count), one_b(count), one_c(count);
      for (std::size_t i = 0; i < count; ++i) {
        one_a[i] = a[i * stride + item];
        one_b[i] = b[i * stride + item];
      }
      tensor.multiply(one_a, one_b, one_c);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(c[i * stride + item], one_c[i],
                    1e-5);  // order of operations in single precision
      }
    }
    EXPECT_EQ(c[n], 9.0F);
    // The same with the first item's function fixed.
    Coefficients fixed(count);
    for (std::size_t i = 0; i < count; ++i) fixed[i] = a[i * stride];
    const std::vector<double> matrix = tensor.matrixOf(fixed);
    const std::vector<float> single(matrix.begin(), matrix.end());
    std::fill(c.begin(), c.end(), 9.0F);
    multiplyByMatrixBatch(single, count, b.data(), c.data(), n, stride);
    for (std::size_t item = 0; item < n; ++item) {
      std::vector<float> one_b(count), one_c(count);
      for (std::size_t i = 0; i < count; ++i) one_b[i] = b[i * stride + item];
      multiplyByMatrix(single, one_b, one_c);
      for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(c[i * stride + item], one_c[i], 1e-5);
    }
    EXPECT_EQ(c[n], 9.0F);
  }
}

TEST(TripleProduct, InnerProductIsTheIntegralOfTheProduct) {
  Rng rng(76);
  const Coefficients a = randomCoefficients(5, rng), b = randomCoefficients(5, rng);
  Coefficients c(25);
  TripleProduct::ofBands(5).multiply(a, b, c);
  EXPECT_NEAR(c[0] * 2.0 * std::sqrt(kPi), innerProduct(a, b), 1000 * kEps);
}

}  // namespace
}  // namespace soffit::sh
