// SPDX-License-Identifier: MIT
#include "core/photometry/grid.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::photometry {
namespace {

TEST(Grid, SpacingFollowsTheNorm) {
  constexpr double kRoundoff = 16 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(gridSpacing(1.0), 0.2, kRoundoff);
  EXPECT_NEAR(gridSpacing(10.0), 1.0, kRoundoff);
  EXPECT_NEAR(gridSpacing(100.0), 5.0, 5 * kRoundoff);
  EXPECT_EQ(gridSpacing(1e6), 10.0);
  EXPECT_NEAR(gridSpacing(5.0), 0.6160, 0.00005);  // the table of EN 12464-1 rounds it to 0.6
}

TEST(Grid, TheLongerSideRulesUntilTheRatioIsTwo) {
  const GridCounts office = gridCounts(10.0, 6.0);  // d = 10, p = 1
  EXPECT_EQ(office.nu, 10);
  EXPECT_EQ(office.nv, 6);
  const GridCounts corridor = gridCounts(20.0, 1.0);  // d = 1, p = 0.2
  EXPECT_EQ(corridor.nu, 100);
  EXPECT_EQ(corridor.nv, 5);
  const GridCounts turned = gridCounts(1.0, 20.0);
  EXPECT_EQ(turned.nu, 5);
  EXPECT_EQ(turned.nv, 100);
}

TEST(Grid, ThereIsAlwaysAPoint) {
  const GridCounts speck = gridCounts(1e-9, 1e-9);
  EXPECT_GE(speck.nu, 1);
  EXPECT_GE(speck.nv, 1);
}

}  // namespace
}  // namespace soffit::photometry
