// SPDX-License-Identifier: MIT
#include "core/design/error_figures.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace soffit::design {
namespace {

constexpr double kRoundoff = 64 * std::numeric_limits<double>::epsilon();

ErrorSamples samples(const std::vector<double>& value, const std::vector<double>& reference,
                     const std::vector<double>& noise = {}) {
  ErrorSamples s;
  for (std::size_t i = 0; i < value.size(); ++i) {
    s.add(value[i], reference[i], noise.empty() ? 0.0 : noise[i]);
  }
  return s;
}

TEST(ErrorFigures, FollowTheirDefinitions) {
  const ErrorFigures f = errorFigures(samples({110, 190, 300, 410}, {100, 200, 300, 400}));
  EXPECT_EQ(f.receivers, 4U);
  EXPECT_DOUBLE_EQ(f.mean_lux, 250.0);
  EXPECT_NEAR(f.rms, std::sqrt(300.0 / 4.0) / 250.0, kRoundoff);
  EXPECT_NEAR(f.rms_raw, f.rms, kRoundoff);
  EXPECT_NEAR(f.bias, 10.0 / 4.0 / 250.0, kRoundoff);
  EXPECT_EQ(f.reference_stderr, 0.0);
  EXPECT_EQ(f.rms_stderr, 0.0);
  // Relative errors 0, 0.025, 0.05, 0.1: the 95th percentile (type 7) lies at 2.85 of 0..3.
  EXPECT_NEAR(f.p95, 0.05 + 0.85 * 0.05, kRoundoff);
}

TEST(ErrorFigures, DarkReceiversAreMeasuredAgainstAShareOfTheMean) {
  // Mean 100, so the floor is 5 lx: an error of 1 lx where there is no light counts 0.2.
  const ErrorFigures f = errorFigures(samples({1, 200}, {0, 200}));
  EXPECT_NEAR(f.p95, 0.95 * 0.2, kRoundoff);
}

TEST(ErrorFigures, NoiseOfTheReferenceIsSubtractedInSquares) {
  const ErrorFigures f = errorFigures(samples({105, 95}, {100, 100}, {3, 3}));
  EXPECT_NEAR(f.rms_raw, 0.05, kRoundoff);
  EXPECT_NEAR(f.rms, 0.04, kRoundoff);  // 5^2 - 3^2 = 4^2
  EXPECT_NEAR(f.reference_stderr, 0.03, kRoundoff);
  EXPECT_NEAR(f.bias_stderr, 0.03 / std::sqrt(2.0), kRoundoff);
  // sd(rms^2) = sqrt(sum(4 e^2 s^2 + 2 s^4)) / N with e = 4, s = 3 in percent.
  const double spread = std::sqrt(2.0 * (4.0 * 16.0 * 9.0 + 2.0 * 81.0)) / 2.0 * 1e-4;
  EXPECT_NEAR(f.rms_stderr, spread / (2.0 * 0.04), kRoundoff);
}

TEST(ErrorFigures, NoiseAloneLeavesNoError) {
  // The noise that is stated is larger than the deviations: nothing is left, not a NaN.
  const ErrorFigures f = errorFigures(samples({101, 99}, {100, 100}, {3, 3}));
  EXPECT_EQ(f.rms, 0.0);
  EXPECT_GT(f.rms_stderr, 0.0);
}

TEST(ErrorFigures, NoisyReferencesGiveTheTrueRms) {
  // 4000 receivers, errors of 2 %, noise of 3 %: rms_stderr is the standard deviation of rms.
  Rng rng(7);
  const auto gauss = [&] {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += rng.uniformDouble();
    return sum;
  };
  ErrorSamples s;
  for (int i = 0; i < 4000; ++i) s.add(100.0 + 2.0 * gauss(), 100.0 + 3.0 * gauss(), 3.0);
  const ErrorFigures f = errorFigures(s);
  // The 2 % themselves are a sample: their own spread is 2 % / sqrt(2 N).
  const double spread = std::hypot(f.rms_stderr, 0.02 / std::sqrt(8000.0));
  EXPECT_NEAR(f.rms, 0.02, 4.0 * spread);  // statistical, 4 sigma: 6e-5 of false alarms
  EXPECT_NEAR(f.bias, 0.0, 4.0 * std::hypot(0.02, 0.03) / std::sqrt(4000.0));
}

TEST(ErrorFigures, AreZeroWithoutReceiversOrLight) {
  const ErrorFigures none = errorFigures({});
  EXPECT_EQ(none.receivers, 0U);
  EXPECT_EQ(none.rms, 0.0);
  const ErrorFigures dark = errorFigures(samples({1, 2}, {0, 0}));
  EXPECT_EQ(dark.receivers, 2U);
  EXPECT_EQ(dark.rms, 0.0);
  EXPECT_EQ(dark.p95, 0.0);
}

TEST(PooledFigures, WeighEachSetByItsOwnMean) {
  const std::vector<ErrorSamples> sets{samples({11, 11}, {10, 10}), samples({970}, {1000})};
  const ErrorFigures f = pooledFigures(sets);
  EXPECT_EQ(f.receivers, 3U);
  EXPECT_DOUBLE_EQ(f.mean_lux, 505.0);
  EXPECT_NEAR(f.rms, std::sqrt((0.01 + 0.0009) / 2.0), kRoundoff);
  EXPECT_NEAR(f.bias, (0.1 - 0.03) / 2.0, kRoundoff);
  EXPECT_NEAR(f.p95, 0.1, kRoundoff);
}

}  // namespace
}  // namespace soffit::design
