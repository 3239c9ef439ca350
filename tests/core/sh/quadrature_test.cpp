// SPDX-License-Identifier: MIT
#include "core/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace soffit {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(GaussLegendre, IsExactToTwiceItsNumberOfNodes) {
  for (const int n : {1, 2, 3, 5, 8, 16, 33}) {
    const QuadratureRule rule = gaussLegendre(n);
    for (int degree = 0; degree < 2 * n; ++degree) {
      double sum = 0.0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
      }
      const double exact = degree % 2 == 0 ? 2.0 / (degree + 1.0) : 0.0;
      EXPECT_NEAR(sum, exact, 64 * kEps) << n << " nodes, degree " << degree;
    }
  }
}

TEST(GaussLegendre, MissesTheNextDegreeByItsKnownRemainder) {
  const QuadratureRule rule = gaussLegendre(2);  // nodes +-1/sqrt 3: sum of t^4 is 2/9, not 2/5
  EXPECT_NEAR(rule.nodes[1], 1.0 / std::sqrt(3.0), 2 * kEps);
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], 4);
  EXPECT_NEAR(sum, 2.0 / 9.0, 4 * kEps);
}

TEST(GaussLegendre, HasPositiveWeightsInAscendingOrderOnAnyInterval) {
  const QuadratureRule rule = gaussLegendre(100, 2.0, 5.0);
  EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 3.0, 300 * kEps);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    EXPECT_GT(rule.weights[i], 0.0);
    EXPECT_GT(rule.nodes[i], i == 0 ? 2.0 : rule.nodes[i - 1]);
  }
  EXPECT_LT(rule.nodes.back(), 5.0);
}

}  // namespace
}  // namespace soffit
