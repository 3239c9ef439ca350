// SPDX-License-Identifier: MIT
#include "tests/projects/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit {
namespace {

scene::Image plain(float r, float g, float b) {
  scene::Image image{.width = 20, .height = 10, .channels = 3, .pixels = {}};
  for (int i = 0; i < 200; ++i) image.pixels.insert(image.pixels.end(), {r, g, b});
  return image;
}

TEST(PictureDifference, IsZeroOfAPictureWithItself) {
  const PictureDifference d = pictureDifference(plain(0.2F, 0.4F, 0.6F), plain(0.2F, 0.4F, 0.6F));
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(d.p99, 0.0);
  EXPECT_EQ(d.lightness, 0.0);
}

TEST(PictureDifference, BlackAndWhiteAreAHundredApart) {
  const PictureDifference d = pictureDifference(plain(1, 1, 1), plain(0, 0, 0));
  // The matrix has seven digits.
  EXPECT_NEAR(d.mean, 100.0, 1e-2);
  EXPECT_NEAR(d.lightness, 100.0, 1e-2);
  EXPECT_LT(pictureDifference(plain(0, 0, 0), plain(1, 1, 1)).lightness, -99.0);
}

TEST(PictureDifference, KnowsTheColoursOfThePrimaries) {
  // L*a*b* of the sRGB primaries as published (Lindbloom): red (53.24, 80.09, 67.20), green
  // (87.73, -86.18, 83.18); two decimals.
  const double expected = std::sqrt(std::pow(87.73 - 53.24, 2) + std::pow(86.18 + 80.09, 2) +
                                    std::pow(83.18 - 67.20, 2));
  EXPECT_NEAR(pictureDifference(plain(1, 0, 0), plain(0, 1, 0)).mean, expected, 0.05);
}

TEST(PictureDifference, TheWorstPixelsAreInThePercentiles) {
  scene::Image image = plain(0.5F, 0.5F, 0.5F);
  // A block of 5 x 5 of 200 pixels: an eighth.
  for (std::size_t y = 0; y < 5; ++y) {
    for (std::size_t x = 0; x < 5; ++x) image.pixels[3 * (20 * y + x)] = 1.0F;
  }
  const PictureDifference d = pictureDifference(image, plain(0.5F, 0.5F, 0.5F));
  EXPECT_GT(d.p95, 20.0);
  EXPECT_GE(d.p99, d.p95);
  EXPECT_GT(d.p95, d.mean);
  EXPECT_NEAR(d.lightness, 0.0, 1e-12);  // the median does not move
}

}  // namespace
}  // namespace soffit
