// SPDX-License-Identifier: MIT
#include "core/sh/basis.h"

#include "core/sh/polynomials.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::sh {
namespace {

TEST(Index, DegreeAndOrderAreUndone) {
  std::size_t i = 0;
  for (int l = 0; l < kMaxBands; ++l) {
    for (int m = -l; m <= l; ++m, ++i) {
      EXPECT_EQ(index(l, m), i);
      EXPECT_EQ(degreeOf(i), l);
      EXPECT_EQ(orderOf(i), m);
    }
  }
  EXPECT_EQ(bandsOf(kMaxCoefficients), kMaxBands);
}

TEST(Basis, IsOrthonormalToTenBands) {
  // The product of two functions has degree 18, which the rule integrates exactly.
  const SphereSamples rule = cubature(2 * (kMaxBands - 1));
  std::vector<double> gram(kMaxCoefficients * kMaxCoefficients, 0.0);
  std::array<double, kMaxCoefficients> y;
  for (std::size_t k = 0; k < rule.size(); ++k) {
    evaluate(rule.directions[k], kMaxBands, y);
    for (std::size_t i = 0; i < y.size(); ++i) {
      for (std::size_t j = 0; j < y.size(); ++j) {
        gram[i * y.size() + j] += rule.weights[k] * y[i] * y[j];
      }
    }
  }
  // 190 directions, each product within a few ulp of at most 10 (the largest y^2).
  constexpr double kRoundoff = 190 * kEps;
  for (std::size_t i = 0; i < y.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      EXPECT_NEAR(gram[i * y.size() + j], i == j ? 1.0 : 0.0, kRoundoff) << i << ", " << j;
    }
  }
}

TEST(Basis, HasNoCondonShortleySign) {
  const dvec3 d = glm::normalize(dvec3(1, 2, 3));
  std::array<double, 4> y;
  evaluate(d, 2, y);
  const double k = std::sqrt(3.0 / (4.0 * kPi));
  EXPECT_NEAR(y[0], 0.5 / std::sqrt(kPi), 2 * kEps);
  EXPECT_NEAR(y[1], k * d.y, 2 * kEps);
  EXPECT_NEAR(y[2], k * d.z, 2 * kEps);
  EXPECT_NEAR(y[3], k * d.x, 2 * kEps);
}

TEST(Basis, PolynomialsEqualTheRecurrence) {
  std::array<double, 25> a, b;
  for (const dvec3& d : testDirections(2000, 1)) {
    polynomials<5>(d.x, d.y, d.z, a.data());
    evaluateByRecurrence(d, 5, b);
    EXPECT_LE(largestDifference(a, b), 16 * kEps);
    std::array<float, 25> af, bf;
    const vec3 f(d);
    polynomials<5>(f.x, f.y, f.z, af.data());
    evaluateByRecurrence(f, 5, bf);
    for (std::size_t i = 0; i < af.size(); ++i)
      EXPECT_NEAR(af[i], bf[i], 1e-6F);  // single precision
  }
}

TEST(Basis, FewerBandsAreTheFirstOfMore) {
  const dvec3 d = glm::normalize(dvec3(-0.3, 0.5, 0.2));
  std::array<double, kMaxCoefficients> all;
  evaluate(d, kMaxBands, all);
  for (int bands = 1; bands <= kMaxBands; ++bands) {
    std::vector<double> some(coefficientCount(bands));
    evaluate(d, bands, some);
    for (std::size_t i = 0; i < some.size(); ++i) EXPECT_NEAR(some[i], all[i], 16 * kEps);
  }
}

// Unsold's theorem: sum over m of y_lm^2 = (2l + 1) / 4 pi in every direction, poles included.
TEST(Basis, SquaresOfABandAddUpEverywhere) {
  std::array<double, kMaxCoefficients> y;
  for (const dvec3& d : testDirections(500, 2)) {
    evaluate(d, kMaxBands, y);
    for (int l = 0; l < kMaxBands; ++l) {
      double sum = 0.0;
      for (int m = -l; m <= l; ++m) sum += y[index(l, m)] * y[index(l, m)];
      const double exact = (2.0 * l + 1.0) / (4.0 * kPi);
      EXPECT_NEAR(sum, exact, exact * 64 * kEps);
    }
  }
}

TEST(Basis, SinglePrecisionKeepsSevenMillionths) {
  std::array<double, kMaxCoefficients> exact;
  std::array<float, kMaxCoefficients> single;
  double worst = 0.0;
  for (const dvec3& d : testDirections(5000, 3)) {
    const vec3 f = glm::normalize(vec3(d));
    evaluate(f, kMaxBands, single);
    evaluate(dvec3(f), kMaxBands, exact);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      worst = std::max(worst, std::abs(exact[i] - single[i]));
    }
  }
  EXPECT_LT(worst, 7e-6);  // the figure of numerics.md 1.1
}

TEST(Basis, GradientsAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  std::array<double, kMaxCoefficients> y, low, high, along;
  std::array<dvec3, kMaxCoefficients> gradient;
  for (const dvec3& d : testDirections(50, 4)) {
    evaluateWithGradient(d, kMaxBands, y, gradient);
    evaluateByRecurrence(d, kMaxBands, low);
    EXPECT_LE(largestDifference(y, low), 32 * kEps);
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0.0);
      step[axis] = kStep;
      evaluateByRecurrence(d - step, kMaxBands, low);
      evaluateByRecurrence(d + step, kMaxBands, high);
      for (std::size_t i = 0; i < y.size(); ++i) {
        // Truncation h^2/6 times the third derivative (below 2.4e4 at degree 9), rounding eps / h.
        EXPECT_NEAR(gradient[i][axis], (high[i] - low[i]) / (2.0 * kStep), 4e-7) << i;
      }
    }
    const dvec3 tangent = glm::cross(d, dvec3(0.3, -0.7, 0.2));
    evaluateDerivative(d, tangent, kMaxBands, along);
    for (std::size_t i = 0; i < y.size(); ++i) {
      EXPECT_NEAR(along[i], glm::dot(gradient[i], tangent), 256 * kEps);
    }
  }
}

}  // namespace
}  // namespace soffit::sh
