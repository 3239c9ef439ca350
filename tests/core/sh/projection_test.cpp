// SPDX-License-Identifier: MIT
#include "core/sh/projection.h"

#include "core/sh/cube_map.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::sh {
namespace {

// The tutorial's listing drops green: constant light must reach all three channels, and c00 only.
TEST(Projection, ConstantLightGivesOnlyBandZeroInAllThreeChannels) {
  const dvec3 light(100.0, 70.0, 30.0);
  const auto rgb = project([&](const dvec3&) { return light; }, cubature(9), kMaxBands);
  for (int c = 0; c < 3; ++c) {
    const Coefficients& channel = rgb[static_cast<std::size_t>(c)];
    const double expected = light[c] * 2.0 * std::sqrt(kPi);
    EXPECT_NEAR(channel[0], expected, expected * 100 * kEps);
    EXPECT_LE(largest(std::span(channel).subspan(1)), expected * 100 * kEps);
  }
}

TEST(Projection, GivesBackWhatCoefficientsDescribe) {
  Rng rng(11);
  for (int bands = 1; bands <= kMaxBands; ++bands) {
    const Coefficients c = randomCoefficients(bands, rng);
    const auto f = [&](const dvec3& d) { return reconstruct(c, d); };
    EXPECT_LE(largestDifference(project(f, cubature(2 * (bands - 1)), bands), c), 1000 * kEps);
  }
}

TEST(Projection, MonteCarloIsUnbiasedWithinItsStandardError) {
  Rng rng(12);
  const Coefficients c = randomCoefficients(4, rng);
  const auto f = [&](const dvec3& d) { return reconstruct(c, d); };
  const Coefficients estimate = project(f, randomSamples(40000, 13), 4);
  // sigma of one coefficient is at most 4 pi max|f y| / sqrt n < 4 pi x 4 / 200; f is below 3, and
  // RMS of f y is far below. 16 coefficients at 5 sigma of RMS(f y) ~ 0.4: 0.125.
  EXPECT_LE(largestDifference(estimate, c), 0.125);
}

TEST(ProjectionTable, EqualsProjectionOneSampleAtATime) {
  const SphereSamples samples = cubeSamples(17);  // no whole number of blocks
  const auto f = [](const dvec3& d) {
    return dvec3(1.0 + d.x, std::max(0.0, d.z), std::exp(3.0 * d.y));
  };
  std::array<std::vector<float>, 3> values;
  for (const dvec3& d : samples.directions) {
    for (int c = 0; c < 3; ++c) values[static_cast<std::size_t>(c)].push_back(float(f(d)[c]));
  }
  for (const int bands : {1, 3, 5, 10}) {
    const ProjectionTable table(samples, bands);
    const RgbCoefficients exact = project(f, samples, bands);
    const RgbCoefficients fast = table.project(values[0], values[1], values[2]);
    for (std::size_t c = 0; c < 3; ++c) {
      // Single-precision table and values: relative to the integral of |f|.
      EXPECT_LE(largestDifference(exact[c], fast[c]), 2e-6 * exact[c][0]);
      EXPECT_EQ(table.project(values[c]), fast[c]);
    }
  }
}

TEST(Reconstruct, IsLinear) {
  Rng rng(14);
  const Coefficients a = randomCoefficients(6, rng), b = randomCoefficients(6, rng);
  Coefficients sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = 2.0 * a[i] - 3.0 * b[i];
  const dvec3 d = randomDirection(rng);
  EXPECT_NEAR(reconstruct(sum, d), 2.0 * reconstruct(a, d) - 3.0 * reconstruct(b, d), 1e3 * kEps);
}

}  // namespace
}  // namespace soffit::sh
