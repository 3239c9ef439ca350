// SPDX-License-Identifier: MIT
#include "core/photometry/intensity_distribution.h"

#include "core/photometry/angle_lookup.h"
#include "tests/core/photometry/distributions.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::photometry {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

double ones(double, double) {
  return 1.0;
}

TEST(IntensityDistribution, AUniformSphereHasFourPiLumensWhateverTheKnots) {
  // The sine is integrated exactly: only the rounding of some tens of terms is left.
  EXPECT_NEAR(tabulate(ones, 1, 2).flux(), 4.0 * kPi, 100 * kEps);
  EXPECT_NEAR(tabulate(ones, 24, 37).flux(), 4.0 * kPi, 1000 * kEps);
  IntensityDistribution uneven = tabulate(ones, 1, 4);
  uneven.c_deg = {0.0, 10.0, 11.0, 200.0};
  uneven.gamma_deg = {0.0, 0.5, 170.0, 180.0};
  uneven.candela.assign(16, 1.0);
  EXPECT_NEAR(uneven.flux(), 4.0 * kPi, 1000 * kEps);
}

TEST(IntensityDistribution, LinearInGammaIntegratesInClosedForm) {
  // ∫₀^{π/2} (1 - γ/(π/2)) sin γ dγ = 1 - 2/π, times 2π.
  const auto d = tabulate([](double, double g) { return 1.0 - 2.0 * g / kPi; }, 1, 2, 0.0, 90.0);
  EXPECT_NEAR(d.flux(), 2.0 * kPi - 4.0, 100 * kEps);
}

TEST(IntensityDistribution, CosineFluxFallsToPiQuadratically) {
  // Truncation: linear interpolation errs by h²/12 of the curvature, so halving h quarters it.
  const auto error = [](int knots) {
    const auto cosine = [](double, double g) { return std::cos(g); };
    return std::abs(tabulate(cosine, 1, knots, 0.0, 90.0).flux() - kPi);
  };
  EXPECT_LT(error(91), 1e-4);
  EXPECT_NEAR(error(46) / error(91), 4.0, 0.01);
}

TEST(IntensityDistribution, AnAsymmetricTableIsTrapezoidalInC) {
  // Planes 3, 5, 7, 9 cd at 0, 90, 180, 270: the mean is 6 on an even circle.
  IntensityDistribution d;
  d.c_deg = {0.0, 90.0, 180.0, 270.0};
  d.gamma_deg = {0.0, 180.0};
  d.candela = {3, 3, 5, 5, 7, 7, 9, 9};
  EXPECT_NEAR(d.flux(), 24.0 * kPi, 1000 * kEps);
}

TEST(IntensityDistribution, ReadsItsOwnKnotsAndIsLinearBetween) {
  IntensityDistribution d;
  d.c_deg = {0.0, 90.0, 180.0, 270.0};
  d.gamma_deg = {0.0, 45.0, 90.0};
  d.candela = {10, 20, 30, 10, 40, 60, 10, 0, 0, 10, 80, 100};
  constexpr double kAngleRoundoff = 100 * 16 * kEps;  // cd per degree times rounding of atan2
  EXPECT_NEAR(d.intensity(toward(0, 45)), 20.0, kAngleRoundoff);
  EXPECT_NEAR(d.intensity(toward(90, 90)), 60.0, kAngleRoundoff);
  EXPECT_NEAR(d.intensity(toward(45, 45)), 30.0, kAngleRoundoff);
  EXPECT_NEAR(d.intensity(toward(90, 67.5)), 50.0, kAngleRoundoff);
  EXPECT_NEAR(d.intensity(toward(315, 45)), 50.0, kAngleRoundoff) << "closes from C270 to C0";
  EXPECT_NEAR(d.intensityAt(-45.0, 45.0), 50.0, kAngleRoundoff);
  EXPECT_NEAR(d.intensityAt(405.0, 45.0), 30.0, kAngleRoundoff);
}

TEST(IntensityDistribution, SenseOfCIsCounterClockwiseFromAboveAndGammaZeroIsDown) {
  IntensityDistribution d;
  d.c_deg = {0.0, 90.0, 180.0, 270.0};
  d.gamma_deg = {0.0, 90.0, 180.0};
  d.candela = {1, 10, 2, 1, 20, 2, 1, 30, 2, 1, 40, 2};
  EXPECT_DOUBLE_EQ(d.intensity({0, 0, -1}), 1.0);
  EXPECT_DOUBLE_EQ(d.intensity({0, 0, 1}), 2.0);
  EXPECT_DOUBLE_EQ(d.intensity({1, 0, 0}), 10.0);
  EXPECT_DOUBLE_EQ(d.intensity({0, 1, 0}), 20.0);
  EXPECT_DOUBLE_EQ(d.intensity({-1, 0, 0}), 30.0);
  EXPECT_DOUBLE_EQ(d.intensity({0, -1, 0}), 40.0);
}

TEST(IntensityDistribution, OutsideItsGammaRangeItIsDark) {
  const auto down = tabulate(ones, 1, 3, 0.0, 90.0);
  EXPECT_EQ(down.intensity({1, 0, 0}), 1.0);
  EXPECT_EQ(down.intensity(toward(0, 90.001)), 0.0);
  EXPECT_EQ(down.intensity({0, 0, 1}), 0.0);
  EXPECT_NEAR(down.flux(), 2.0 * kPi, 100 * kEps);
  const auto up = tabulate(ones, 1, 3, 90.0, 180.0);
  EXPECT_EQ(up.intensity({0, 0, -1}), 0.0);
  EXPECT_EQ(up.intensity({0, 0, 1}), 1.0);
}

TEST(IntensityDistribution, KnotsThatNearlyCoincideDoNoHarm) {
  // A damaged file had angles 1e-320 degrees apart: the slope between them was infinite.
  IntensityDistribution d = tabulate(ones, 1, 4);
  d.gamma_deg = {0.0, 1e-320, 90.0, 90.0 + 1e-13};
  d.candela = {5.0, 1.0, 1.0, 7.0};
  EXPECT_NEAR(d.flux(), 2.0 * kPi, 1e4 * kEps);
}

TEST(IntensityDistribution, NotANumberIsDark) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tabulate(ones, 1, 3).intensity({nan, nan, nan}), 0.0);
}

TEST(IntensityDistribution, PeakIsTheGreatestEntry) {
  EXPECT_EQ(tabulate([](double c, double g) { return c + g; }, 4, 3, 0, 180).peak(),
            radians(270.0) + kPi);
  EXPECT_EQ(IntensityDistribution{}.peak(), 0.0);
}

TEST(AngleLookup, UnevenTablesAreSearchedLikeEvenOnes) {
  const std::vector<double> knots{0.0, 1.0, 2.0, 50.0, 90.0, 91.0, 180.0};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (const double t : {0.0, 0.25, 0.75}) {
      const Bracket b = bracket(knots, knots[i] + t * (knots[i + 1] - knots[i]));
      EXPECT_EQ(b.index, i);
      EXPECT_NEAR(b.t, t, 64 * kEps);
    }
  }
  EXPECT_EQ(bracket(knots, 180.0).index, 5u);
  EXPECT_EQ(bracket(knots, 180.0).t, 1.0);
  EXPECT_EQ(bracket(knots, -4.0).t, 0.0);
}

}  // namespace
}  // namespace soffit::photometry
