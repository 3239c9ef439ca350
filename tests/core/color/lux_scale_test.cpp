// SPDX-License-Identifier: MIT
#include "core/color/lux_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soffit::color {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

std::vector<std::string> labels(const LuxScale& scale, int most) {
  std::vector<std::string> names;
  for (const LegendTick& tick : legendTicks(scale, most)) names.push_back(tick.label);
  return names;
}

TEST(LuxScale, StepsAreBandsThatUseTheWholeMap) {
  const LuxScale scale{.range = {0.0, 500.0}, .steps = 5};
  EXPECT_EQ(scale.color(0.0F), colorMapAt(scale.map, 0.0F));
  EXPECT_EQ(scale.color(99.0F), scale.color(1.0F));
  EXPECT_NE(scale.color(101.0F), scale.color(99.0F));
  EXPECT_EQ(scale.color(250.0F), colorMapAt(scale.map, 0.5F));
  EXPECT_EQ(scale.color(9999.0F), colorMapAt(scale.map, 1.0F));
}

TEST(LuxScale, ValuesOfALegendWithStepsAreTheirBorders) {
  const LuxScale scale{.range = {0.0, 500.0}, .steps = 5};
  EXPECT_THAT(labels(scale, 10), ElementsAre("0", "100", "200", "300", "400", "500"));
  EXPECT_THAT(labels(scale, 3), ElementsAre("0", "300"));
  const LuxScale decades{.range = {1.0, 1000.0, true}, .steps = 3};
  EXPECT_THAT(labels(decades, 10), ElementsAre("1", "10", "100", "1000"));
}

TEST(LuxScale, FootcandlesAreRoundInTheirUnit) {
  const LuxScale scale{.range = {0.0, 50.0 * kLuxPerFootcandle}, .unit = LuxUnit::footcandle};
  const auto ticks = legendTicks(scale, 6);
  EXPECT_THAT(labels(scale, 6), ElementsAre("0", "10", "20", "30", "40", "50"));
  // Round-off: a product and a quotient.
  EXPECT_NEAR(ticks[1].lux, 107.63910416709722, 1e-12 * 108.0);
}

TEST(IsoLevels, RoundOnesAreThoseOfTheLegendAboveZero) {
  EXPECT_THAT(isoLevels({.range = {0.0, 500.0}}, LevelSeries::round),
              ElementsAre(50, 100, 150, 200, 250, 300, 350, 400, 450, 500));
  EXPECT_THAT(isoLevels({.range = {10.0, 1000.0, true}}, LevelSeries::round),
              ElementsAre(DoubleNear(10, 1e-9), DoubleNear(20, 1e-9), DoubleNear(50, 1e-9),
                          DoubleNear(100, 1e-9), DoubleNear(200, 1e-9), DoubleNear(500, 1e-9),
                          DoubleNear(1000, 1e-9)));
}

TEST(IsoLevels, TheStandardSeriesIsThatOfTheStandards) {
  // 0.5 1 2 3 5 7.5 10 15 20 30 50 75 100: 1.5 only from 10 on.
  std::vector<double> expected{0.5, 1, 2, 3, 5, 7.5, 10, 15, 20, 30, 50, 75, 100};
  const auto levels = isoLevels({.range = {0.4, 100.0, true}}, LevelSeries::standard);
  ASSERT_EQ(levels.size(), expected.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
    EXPECT_NEAR(levels[i], expected[i], 1e-9 * expected[i]);
  EXPECT_THAT(isoLevels({.range = {0.0, 500.0}}, LevelSeries::standard),
              ElementsAre(10, 15, 20, 30, 50, 75, 100, 150, 200, 300, 500));
}

TEST(IsoLevels, ChosenOnesAreSortedAndThoseThatAreNoneLeftOut) {
  EXPECT_THAT(isoLevels({}, LevelSeries::chosen, {500.0, 0.0, -3.0, 300.0, 500.0}),
              ElementsAre(300, 500));
  EXPECT_EQ(isoLevels({}, LevelSeries::chosen, std::vector<double>(100, 1.0)).size(), 1U);
}

}  // namespace
}  // namespace soffit::color
