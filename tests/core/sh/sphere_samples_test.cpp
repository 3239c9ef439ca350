// SPDX-License-Identifier: MIT
#include "core/sh/sphere_samples.h"

#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace soffit::sh {
namespace {

double weightOf(const SphereSamples& s) {
  return std::accumulate(s.weights.begin(), s.weights.end(), 0.0);
}

/// A smooth lobe and its integral over the sphere.
constexpr double kSharpness = 4.0;
const dvec3 kAxis = glm::normalize(dvec3(0.4, -0.3, 0.7));
double lobe(const dvec3& d) {
  return std::exp(kSharpness * glm::dot(d, kAxis));
}
const double kLobeIntegral = 4.0 * kPi * std::sinh(kSharpness) / kSharpness;

double relativeError(const SphereSamples& s) {
  double sum = 0.0;
  for (std::size_t k = 0; k < s.size(); ++k) sum += s.weights[k] * lobe(s.directions[k]);
  return sum / kLobeIntegral - 1.0;
}

/// RMS over 40 seeds.
template <class Make>
double rmsError(const Make& make) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) sum += std::pow(relativeError(make(seed)), 2);
  return std::sqrt(sum / 40.0);
}

TEST(SphereSamples, AreUnitAndWeighTheWholeSphere) {
  for (const SphereSamples& s : {randomSamples(1000, 1), stratifiedSamples(31, 2),
                                 hammersleySamples(1000), cubature(0), cubature(17)}) {
    EXPECT_NEAR(weightOf(s), 4.0 * kPi, 4.0 * kPi * 1000 * kEps);
    for (const dvec3& d : s.directions) EXPECT_NEAR(glm::length(d), 1.0, 4 * kEps);
  }
}

TEST(SphereSamples, StratifiedIsOnePerCellAndRepeatsBitByBit) {
  constexpr int kSide = 20;
  const SphereSamples a = stratifiedSamples(kSide, 7);
  EXPECT_EQ(a.directions, stratifiedSamples(kSide, 7).directions);
  EXPECT_NE(a.directions, stratifiedSamples(kSide, 8).directions);
  std::vector<int> count(kSide * kSide, 0);
  for (const dvec3& d : a.directions) {
    const double u = 0.5 * (1.0 - d.z);
    double v = std::atan2(d.y, d.x) / (2.0 * kPi);
    if (v < 0.0) v += 1.0;
    ++count[static_cast<std::size_t>(int(u * kSide) * kSide + int(v * kSide))];
  }
  EXPECT_EQ(std::count(count.begin(), count.end(), 1), kSide * kSide);
}

TEST(SphereSamples, StratifiedErrorFallsFasterThanRandom) {
  const double random_1k = rmsError([](auto seed) { return randomSamples(1024, seed); });
  const double random_16k = rmsError([](auto seed) { return randomSamples(16384, seed); });
  const double strata_1k = rmsError([](auto seed) { return stratifiedSamples(32, seed); });
  const double strata_16k = rmsError([](auto seed) { return stratifiedSamples(128, seed); });
  // 16 times the samples: 1/4 of the error when independent, 1/16 when stratified. The RMS of 40
  // is itself known to 11 % (one sigma); the factors stand 4 sigma away from failing.
  EXPECT_NEAR(random_16k / random_1k, 0.25, 0.16);
  EXPECT_NEAR(strata_16k / strata_1k, 1.0 / 16.0, 0.04);
  EXPECT_LT(strata_1k, 0.2 * random_1k);
}

TEST(SphereSamples, HammersleyBeatsStratifiedAt1024Directions) {
  const double strata = rmsError([](auto seed) { return stratifiedSamples(32, seed); });
  EXPECT_LT(std::abs(relativeError(hammersleySamples(1024))), strata);
}

TEST(SphereSamples, CubatureIntegratesItsDegreeExactly) {
  // Every y_lm but y_00 integrates to 0; degree 9 needs a rule of degree 9.
  const auto one = [](const dvec3&) { return 1.0; };
  for (int degree = kMaxBands - 1; degree < kMaxBands + 3; ++degree) {
    const Coefficients c = project(one, cubature(degree), kMaxBands);
    EXPECT_NEAR(c[0], std::sqrt(4.0 * kPi), 100 * kEps);
    EXPECT_LE(largest(std::span(c).subspan(1)), 100 * kEps);
  }
  const Coefficients short_rule = project(one, cubature(kMaxBands - 2), kMaxBands);
  EXPECT_GT(largest(std::span(short_rule).subspan(1)), 0.01);
}

}  // namespace
}  // namespace soffit::sh
