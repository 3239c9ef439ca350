// SPDX-License-Identifier: MIT
#include "core/daylight/sky_table.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::daylight {
namespace {

std::vector<double> ramp() {
  std::vector<double> w(SkyTable::kCells);
  for (std::size_t i = 0; i < w.size(); ++i)
    w[i] = std::max(0.0, SkyTable::direction(i, {0.5, 0.5}).z);
  return w;
}

TEST(SkyTable, CellsAndDirectionsAreInverse) {
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t cell = rng.below(SkyTable::kCells);
    const dvec3 d = SkyTable::direction(
        cell, {0.01 + 0.98 * rng.uniformDouble(), 0.01 + 0.98 * rng.uniformDouble()});
    EXPECT_EQ(SkyTable::cellOf(d), cell);
    EXPECT_NEAR(glm::length(d), 1.0, 1e-14);
  }
}

TEST(SkyTable, DensityIntegratesToOneAndSamplesFollowIt) {
  const SkyTable table(ramp());
  double sum = 0.0;
  for (std::size_t i = 0; i < SkyTable::kCells; ++i) {
    sum += table.density(SkyTable::direction(i, {0.5, 0.5})) * 4.0 * kPi / SkyTable::kCells;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
  // Mean of 1/density over samples is the sphere: variance known to be small for a floor of 2 %.
  Rng rng(5);
  constexpr int kCount = 40000;
  double above = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const SkyTable::Drawn drawn = table.sample({rng.uniformDouble(), rng.uniformDouble()});
    EXPECT_NEAR(drawn.density, table.density(drawn.direction), 1e-9);
    above += drawn.direction.z > 0.5 ? 1.0 / kCount : 0.0;
  }
  // P(z > 1/2) = (3/4 W + 1/4 F) / (W + F), F = 2 % of W.
  const double wanted = (0.75 + 0.25 * 0.02) / 1.02;
  EXPECT_NEAR(above, wanted, 4.3 * std::sqrt(wanted * (1.0 - wanted) / kCount));
}

TEST(SkyTable, NoLightIsSaidAndStillSampled) {
  const SkyTable dark(std::vector<double>(SkyTable::kCells, 0.0));
  EXPECT_FALSE(dark.anyLight());
  EXPECT_NEAR(dark.density({0, 0, 1}), 1.0 / (4.0 * kPi), 1e-12);
}

}  // namespace
}  // namespace soffit::daylight
