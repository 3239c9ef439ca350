// SPDX-License-Identifier: MIT
#include "core/sh/analytic_light.h"

#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::sh {
namespace {

/// As the tutorial writes it, in angles.
double tutorialFormula(const dvec3& d) {
  const double theta = std::acos(std::clamp(d.z, -1.0, 1.0));
  const double phi = std::atan2(d.y, d.x);
  return std::max(0.0, 5.0 * std::cos(theta) - 4.0) +
         std::max(0.0, -4.0 * std::sin(theta - kPi) * std::cos(phi - 2.5) - 3.0);
}

TEST(AnalyticLight, IsTheTutorialsFormula) {
  for (const dvec3& d : testDirections(2000, 41)) {
    EXPECT_NEAR(AnalyticLight{}(d), tutorialFormula(d), 1e-7);  // acos near the poles
  }
}

// Green 2003 prints the first coefficients from 10,000 stratified samples, with the Condon-Shortley
// sign. The two lobes leave a standard error of about 3e-4 a coefficient; six times that.
TEST(AnalyticLight, MatchesThePublishedCoefficients) {
  struct Published {
    int l, m;
    double value;
  };
  const std::vector<Published> table{
      {0, 0, 0.39925},   {1, -1, -0.21075}, {1, 0, 0.28687},  {1, 1, 0.28277},   {2, -2, -0.31530},
      {2, -1, -0.00040}, {2, 0, 0.13159},   {2, 1, 0.00098},  {3, -2, -0.00072}, {3, -1, 0.12290},
      {3, 0, 0.30458},   {3, 1, -0.16427},  {3, 2, -0.00062}, {3, 3, -0.09126}};
  const Coefficients c = analyticCoefficients({}, 4);
  for (const Published& p : table) {
    const std::size_t i = index(p.l, p.m);
    EXPECT_NEAR(condonShortley(i) * c[i], p.value, 2e-3) << p.l << ", " << p.m;
  }
}

TEST(AnalyticLight, CoefficientsAreThoseOfQuadrature) {
  AnalyticLight light;
  light.overhead_gain = 3.0;
  light.overhead_threshold = 1.0;
  light.side_azimuth = -1.0;
  light.side_threshold = 1.0;
  light.scale = 250.0;
  const Coefficients exact = analyticCoefficients(light, kMaxBands);
  // The kinks leave the rule an error of second order in its 1/600 of the sphere's circumference.
  const Coefficients sum = project(light, cubature(600), kMaxBands);
  EXPECT_LE(largestDifference(sum, exact), 2e-5 * exact[0]);
}

TEST(AnalyticLight, WithoutThresholdItIsTheClampedCosine) {
  const AnalyticLight half{
      .overhead_gain = 1.0, .overhead_threshold = 0.0, .side_gain = 0.0, .side_threshold = 0.0};
  const Coefficients c = analyticCoefficients(half, 3);
  EXPECT_NEAR(c[0], std::sqrt(kPi) / 2.0, 32 * kEps);
  EXPECT_NEAR(c[index(1, 0)], std::sqrt(kPi / 3.0), 32 * kEps);
  EXPECT_NEAR(c[index(1, 1)], 0.0, 32 * kEps);
}

}  // namespace
}  // namespace soffit::sh
