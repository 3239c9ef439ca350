// SPDX-License-Identifier: MIT
#include "core/color/false_color.h"

#include "core/color/display_transform.h"
#include "core/color/srgb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace soffit::color {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels(const FalseColorRange& range, int most) {
  std::vector<std::string> names;
  for (const LegendTick& tick : legendTicks(range, most)) names.push_back(tick.label);
  return names;
}

/// Oklab lightness of an sRGB colour (Ottosson 2020).
double lightness(const vec3& code) {
  const double r = static_cast<double>(srgbDecode(code.x));
  const double g = static_cast<double>(srgbDecode(code.y));
  const double b = static_cast<double>(srgbDecode(code.z));
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

TEST(FalseColorMap, LightnessRisesEvenly) {
  for (int i = 0; i < 100; ++i) {
    const float place = static_cast<float>(i) / 100.0F;
    const double step = lightness(falseColorAt(place + 0.01F)) - lightness(falseColorAt(place));
    // 0.74 over the map; truncation: linear pieces between 33 points, half a step either way.
    EXPECT_NEAR(step, 0.0074, 0.0037) << place;
  }
}

TEST(FalseColorMap, IsTheMapOfTheOcioView) {
  const auto view = DisplayTransform::create({.view = kFalseColorView});
  ASSERT_TRUE(view.ok()) << view.error().message();
  for (int i = 0; i <= 64; ++i) {
    const float place = static_cast<float>(i) / 64.0F;
    std::vector<vec3> pixel{vec3(place)};
    view->apply(pixel);
    const vec3 own = falseColorAt(place);
    // The points of this map are printed to four digits.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[0][c], own[c], 6e-5F) << place;
  }
}

TEST(FalseColorMap, ClampsAndSurvivesNan) {
  EXPECT_EQ(falseColorAt(-1.0F), falseColorAt(0.0F));
  EXPECT_EQ(falseColorAt(2.0F), falseColorAt(1.0F));
  EXPECT_EQ(falseColorAt(std::numeric_limits<float>::quiet_NaN()), falseColorAt(0.0F));
}

TEST(FalseColorRange, PlacesLinearlyOrByLogarithm) {
  const FalseColorRange linear{100, 500, false};
  EXPECT_FLOAT_EQ(linear.place(200), 0.25F);
  EXPECT_EQ(linear.place(50), 0.0F);
  EXPECT_EQ(linear.place(900), 1.0F);
  EXPECT_EQ(linear.place(std::numeric_limits<float>::infinity()), 1.0F);
  EXPECT_EQ(linear.place(std::numeric_limits<float>::quiet_NaN()), 0.0F);
  const FalseColorRange logarithmic{1, 1000, true};
  EXPECT_FLOAT_EQ(logarithmic.place(10), 1.0F / 3.0F);
  EXPECT_EQ(logarithmic.place(0), 0.0F);
}

TEST(FalseColorRange, RefusesWhatHasNoScale) {
  EXPECT_TRUE((FalseColorRange{0, 1000, false}.check().ok()));
  EXPECT_EQ(
      (FalseColorRange{500, 100, false}.check().error().message()),
      "false colour range: expected two finite values in ascending order, found 500 to 100 lx. "
      "Give a range such as 0 to 1000.");
  EXPECT_FALSE((FalseColorRange{0, std::numeric_limits<double>::infinity(), false}.check().ok()));
  EXPECT_EQ(
      (FalseColorRange{0, 100, true}.check().error().message()),
      "false colour range: a logarithmic scale cannot start at 0 or below, found 0 to 100 lx. "
      "Start at 1 lx, or use a linear scale.");
}

TEST(LegendTicks, AreRoundNumbers) {
  EXPECT_THAT(labels({0, 1000, false}, 6), ElementsAre("0", "200", "400", "600", "800", "1000"));
  EXPECT_THAT(labels({0, 500, false}, 6), ElementsAre("0", "100", "200", "300", "400", "500"));
  EXPECT_THAT(labels({37, 41, false}, 6), ElementsAre("37", "38", "39", "40", "41"));
  EXPECT_THAT(labels({0, 0.3, false}, 8),
              ElementsAre("0", "0.05", "0.1", "0.15", "0.2", "0.25", "0.3"));
  EXPECT_THAT(labels({1, 1000, true}, 12),
              ElementsAre("1", "2", "5", "10", "20", "50", "100", "200", "500", "1000"));
  EXPECT_THAT(labels({1, 1e6, true}, 8),
              ElementsAre("1", "10", "100", "1000", "10000", "100000", "1e+06"));
  EXPECT_THAT(labels({200, 450, true}, 6), ElementsAre("200", "250", "300", "350", "400", "450"));
}

TEST(LegendTicks, NeverMoreThanAskedFor) {
  for (const double max : {0.7, 3.0, 33.0, 1234.0, 98765.0}) {
    for (const bool logarithmic : {false, true}) {
      for (int most = 2; most < 12; ++most) {
        const auto ticks = legendTicks({0.01, max, logarithmic}, most);
        EXPECT_LE(ticks.size(), static_cast<std::size_t>(most)) << max;
      }
    }
  }
}

TEST(RoundRange, EndsAtOrAboveTheHighestValue) {
  EXPECT_EQ(roundRange(1000).max, 1000);
  EXPECT_EQ(roundRange(1001).max, 1500);
  EXPECT_EQ(roundRange(640).max, 750);
  EXPECT_EQ(roundRange(0.04).max, 0.05);
  EXPECT_EQ(roundRange(0.0).max, 1.0);
}

}  // namespace
}  // namespace soffit::color
