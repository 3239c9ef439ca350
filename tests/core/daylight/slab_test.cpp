// SPDX-License-Identifier: MIT
#include "core/daylight/slab.h"

#include "core/scene/checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::daylight {
namespace {

constexpr double kRoundoff = 1e-13;

TEST(Slab, NormalIncidenceGivesTheTransmittanceOfTheSheet) {
  for (const double t : {0.05, 0.5, 0.88, 0.91}) {
    EXPECT_NEAR(Slab({1.52, t}).at(1.0).transmitted, t, kRoundoff);
  }
  EXPECT_EQ(Slab({1.52, 0.0}).at(1.0).transmitted, 0.0);
}

TEST(Slab, NothingIsLostInAClearSheetAtAnyAngle) {
  const Slab slab({1.52, scene::losslessTransmittance(1.52)});
  for (double c = 0.0; c <= 1.0; c += 0.01) {
    const Slab::Shares s = slab.at(c);
    EXPECT_NEAR(s.transmitted + s.reflected, 1.0, kRoundoff) << c;
  }
}

TEST(Slab, ClearerThanPossibleIsLossless) {
  const double most = scene::losslessTransmittance(1.52);
  EXPECT_NEAR(Slab({1.52, 0.99}).at(1.0).transmitted, most, kRoundoff);
}

TEST(Slab, AbsorptionFollowsBeersLaw) {
  // Index 1: no faces, the way through is d / cos theta.
  const Slab slab({1.0, 0.8});
  for (const double c : {1.0, 0.7, 0.3}) {
    EXPECT_NEAR(slab.at(c).transmitted, std::pow(0.8, 1.0 / c), kRoundoff);
    EXPECT_NEAR(slab.at(c).reflected, 0.0, kRoundoff);
  }
}

TEST(Slab, BrewstersAngleReflectsOnePolarisationAlone) {
  // tan theta = n: the parallel face reflectance is 0, the other ((n^2-1)/(n^2+1))^2.
  const double n = 1.52;
  const Slab slab({n, scene::losslessTransmittance(n)});
  const double rs = std::pow((n * n - 1.0) / (n * n + 1.0), 2.0);
  const double across = (1.0 - rs) / (1.0 + rs);
  EXPECT_NEAR(slab.at(std::cos(std::atan(n))).transmitted, 0.5 * (across + 1.0), kRoundoff);
}

TEST(Slab, GrazingLightIsReflected) {
  const Slab::Shares s = Slab({1.52, 0.88}).at(0.0);
  EXPECT_EQ(s.transmitted, 0.0);
  EXPECT_EQ(s.reflected, 1.0);
  EXPECT_LT(Slab({1.52, 0.88}).at(1e-4).transmitted, 1e-2);
}

TEST(Slab, NeverMoreComesOutThanGoesIn) {
  for (const double index : {1.0, 1.3, 1.52, 2.4, 5.0}) {
    for (const double t : {0.0, 0.3, 0.88, 1.0}) {
      const Slab slab({index, t});
      for (double c = 0.0; c <= 1.0; c += 0.05) {
        const Slab::Shares s = slab.at(c);
        EXPECT_GE(s.transmitted, 0.0);
        EXPECT_GE(s.reflected, -kRoundoff);
        EXPECT_LE(s.transmitted + s.reflected, 1.0 + kRoundoff);
        EXPECT_EQ(slab.at(-c).transmitted, s.transmitted) << "both sides are alike";
      }
    }
  }
}

}  // namespace
}  // namespace soffit::daylight
