// SPDX-License-Identifier: MIT
#include "core/render/pixel_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace soffit::render {
namespace {

TEST(PixelPattern, OneSampleIsTheCentre) {
  EXPECT_EQ(pixelPattern(1), std::vector<vec2>{vec2(0.0F)});
}

TEST(PixelPattern, FourSamplesLieInFourColumnsAndRows) {
  std::set<float> columns;
  std::set<float> rows;
  for (const vec2& p : pixelPattern(4)) {
    columns.insert(p.x);
    rows.insert(p.y);
  }
  EXPECT_EQ(columns.size(), 4U);
  EXPECT_EQ(rows.size(), 4U);
}

TEST(PixelPattern, HasTheTentsMoments) {
  const auto pattern = pixelPattern(256);
  dvec2 mean(0.0);
  dvec2 square(0.0);
  double product = 0.0;
  for (const vec2& p : pattern) {
    EXPECT_LT(std::abs(p.x), 1.0F);
    EXPECT_LT(std::abs(p.y), 1.0F);
    mean += dvec2(p) / 256.0;
    square += dvec2(p) * dvec2(p) / 256.0;
    product += static_cast<double>(p.x) * static_cast<double>(p.y) / 256.0;
  }
  // Truncation of a midpoint rule with 256 strata per axis.
  EXPECT_NEAR(mean.x, 0.0, 1e-4);
  EXPECT_NEAR(mean.y, 0.0, 1e-4);
  EXPECT_NEAR(square.x, 1.0 / 6.0, 1e-3);
  EXPECT_NEAR(square.y, 1.0 / 6.0, 1e-3);
  EXPECT_NEAR(product, 0.0, 1e-3);
}

}  // namespace
}  // namespace soffit::render
