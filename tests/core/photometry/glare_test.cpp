// SPDX-License-Identifier: MIT
#include "core/photometry/glare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace soffit::photometry {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(Glare, UgrOfOneSourceInClosedForm) {
  // L_b = 10 cd/m², L = 1000, ω = 0.004, p = 1: 0.25/10 · 4000 = 100, 8 log10 100 = 16.
  const std::vector<GlareSource> one{{{1000.0}, {0.004}, 1.0}};
  EXPECT_NEAR(ugr(one, {10.0 * kPi}), 16.0, 64 * kEps);
}

TEST(Glare, TenSourcesAddEightUnitsAndAnIndexOfTenTakesSixteen) {
  const std::vector<GlareSource> ten(10, {{1000.0}, {0.004}, 1.0});
  EXPECT_NEAR(ugr(ten, {10.0 * kPi}), 24.0, 256 * kEps);
  const std::vector<GlareSource> aside{{{1000.0}, {0.004}, 10.0}};
  EXPECT_NEAR(ugr(aside, {10.0 * kPi}), 0.0, 256 * kEps);
}

TEST(Glare, OutOfSightIsNoGlare) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<GlareSource> behind{{{1000.0}, {0.004}, inf}};
  EXPECT_EQ(ugr(behind, {10.0}), -inf);
  EXPECT_EQ(ugr({}, {10.0}), -inf);
  EXPECT_EQ(guthPositionIndex(0.0, kPi / 2), inf);
  EXPECT_EQ(positionIndex({1, 0, 0}, {0, 0, 1}, {-1, 0, 0}), inf);
}

TEST(Glare, GuthIsOneOnTheLineOfSightAndGrowsFromIt) {
  EXPECT_EQ(guthPositionIndex(0.3, 0.0), 1.0);
  // Straight above at 10 degrees: exp((35.2 - 1.22)·0.01 + 21·1e-3) = exp(0.3608).
  EXPECT_NEAR(guthPositionIndex(0.0, radians(10.0)), std::exp(0.3608), 64 * kEps);
  // To the side at 20 degrees, by hand from the formula: τ = 90, σ = 20.
  const double linear = (35.2 - 0.31889 * 90 - 1.22 * std::exp(-20.0)) * 0.02;
  const double square = (21 + 0.26667 * 90 - 0.002963 * 8100) * 0.004;
  EXPECT_NEAR(guthPositionIndex(kPi / 2, radians(20.0)), std::exp(linear + square), 256 * kEps);
}

TEST(Glare, DirectionsGiveGuthsAngles) {
  const dvec3 view{1, 0, 0};
  const dvec3 up{0, 0, 1};
  const double s = radians(25.0);
  EXPECT_NEAR(positionIndex(view, up, {std::cos(s), 0, std::sin(s)}), guthPositionIndex(0, s),
              256 * kEps);
  EXPECT_NEAR(positionIndex(view, up, {std::cos(s), std::sin(s), 0}), guthPositionIndex(kPi / 2, s),
              256 * kEps);
  EXPECT_NEAR(positionIndex(view, glm::normalize(dvec3(1, 0, 1)), {std::cos(s), 0, std::sin(s)}),
              guthPositionIndex(0, s), 256 * kEps)
      << "a tilted up is made perpendicular";
}

TEST(Glare, BelowTheLineOfSightIwataAndTokura) {
  const dvec3 view{1, 0, 0};
  const dvec3 up{0, 0, 1};
  EXPECT_NEAR(positionIndex(view, up, glm::normalize(dvec3(1, 0, -0.5))), 1.4, 64 * kEps);
  EXPECT_NEAR(positionIndex(view, up, glm::normalize(dvec3(1, 0, -1))), 2.2, 64 * kEps);
}

}  // namespace
}  // namespace soffit::photometry
