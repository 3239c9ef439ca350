// SPDX-License-Identifier: MIT
#include "core/render/bloom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace soffit::render {
namespace {

constexpr int kWidth = 301;
constexpr int kHeight = 201;

std::vector<vec3> black() {
  return std::vector<vec3>(static_cast<std::size_t>(kWidth) * kHeight, vec3(0.0F));
}
std::size_t at(int x, int y) {
  return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
}

TEST(Bloom, WhatIsNotBrightStaysAsItIs) {
  std::vector<vec3> picture(at(kWidth - 1, kHeight - 1) + 1, vec3(20.0F, 90.0F, 3.0F));
  const auto before = picture;
  addBloom(picture, kWidth, kHeight, {.threshold = 100.0, .strength = 0.5});
  EXPECT_EQ(picture, before);
  addBloom(picture, kWidth, kHeight, {});  // off
  EXPECT_EQ(picture, before);
}

TEST(Bloom, NeitherMakesNorLosesLight) {
  auto picture = black();
  picture[at(150, 100)] = vec3(4e5F, 2e5F, 1e5F);
  addBloom(picture, kWidth, kHeight, {.threshold = 500.0, .strength = 0.2});
  dvec3 sum(0.0);
  for (const vec3& p : picture) {
    sum += dvec3(p);
    ASSERT_GE(p.x, 0.0F);
  }
  EXPECT_NEAR(sum.x / 4e5, 1.0, 1e-4);
  EXPECT_NEAR(sum.z / 1e5, 1.0, 1e-4);
  // A fifth of what exceeds the threshold has left the pixel, but for what the lobes leave there.
  EXPECT_LT(picture[at(150, 100)].x, 0.9F * 4e5F);
}

TEST(Bloom, IsRoundAndFallsOff) {
  auto picture = black();
  picture[at(150, 100)] = vec3(1e6F);
  addBloom(picture, kWidth, kHeight, {.threshold = 1.0, .strength = 1.0});
  for (const int r : {5, 10, 20, 30}) {
    const float right = picture[at(150 + r, 100)].x;
    EXPECT_NEAR(picture[at(150 - r, 100)].x, right, 1e-4F * right);
    EXPECT_NEAR(picture[at(150, 100 + r)].x, right, 1e-4F * right);
    // As far away, but aslant: 3, 4, 5. Means of means are nearly round, out to 2.5 deviations.
    EXPECT_NEAR(picture[at(150 + 3 * r / 5, 100 + 4 * r / 5)].x / right, 1.0, 0.3) << r;
    EXPECT_GT(right, picture[at(150 + 2 * r, 100)].x);
  }
}

TEST(Bloom, HasTheDeviationOfItsLobes) {
  auto picture = black();
  picture[at(150, 100)] = vec3(1e6F);
  addBloom(picture, kWidth, kHeight, {.threshold = 1e-3, .strength = 1.0});
  double squares = 0.0;
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double v = static_cast<double>(picture[at(x, y)].x);
      sum += v;
      squares += v * (x - 150.0) * (x - 150.0);
    }
  }
  const double h = kHeight;
  const double wanted =
      0.5 * std::pow(0.004 * h, 2) + 0.3 * std::pow(0.016 * h, 2) + 0.2 * std::pow(0.06 * h, 2);
  EXPECT_NEAR(squares / sum, wanted, 0.05 * wanted);  // widths are whole pixels
}

TEST(Bloom, DegenerateInputIsHarmless) {
  std::vector<vec3> none;
  addBloom(none, 0, 0, {.threshold = 1.0});
  std::vector<vec3> one{vec3(1e9F)};
  addBloom(one, 1, 1, {.threshold = 1.0, .strength = 5.0});
  EXPECT_TRUE(std::isfinite(one[0].x));
  auto picture = black();
  picture[7] = vec3(std::numeric_limits<float>::infinity());
  picture[8] = vec3(std::numeric_limits<float>::quiet_NaN());
  picture[9] = vec3(1e4F);
  addBloom(picture, kWidth, kHeight, {.threshold = 100.0});
  std::vector<vec3> dark = black();
  dark[7] = vec3(std::numeric_limits<float>::quiet_NaN());
  addBloom(dark, kWidth, kHeight, {.threshold = 100.0});  // nothing is bright, nothing is touched
  EXPECT_EQ(dark[8], vec3(0.0F));
  for (const vec3& p : picture) ASSERT_TRUE(std::isfinite(p.x));
}

}  // namespace
}  // namespace soffit::render
