// SPDX-License-Identifier: MIT
#include "core/color/exposure.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace soffit::color {
namespace {

constexpr double kRoundoff = 1e-6;  // single precision logarithms

TEST(Exposure, OneStopDoubles) {
  EXPECT_FLOAT_EQ(exposureScale(0.0), 0.01F);
  EXPECT_FLOAT_EQ(exposureScale(1.0), 0.02F);
  EXPECT_FLOAT_EQ(exposureScale(-2.0), 0.0025F);
}

TEST(AutoExposure, BringsAnEvenPictureToMidGrey) {
  const std::vector<vec3> picture(200, vec3(72.0F));
  EXPECT_NEAR(autoExposure(picture), -2.0, kRoundoff);  // 72 is two stops above 18
}

TEST(AutoExposure, LeavesBlackAndBrokenPixelsAndTheBrightestPercentOut) {
  std::vector<vec3> picture(200, vec3(18.0F));
  picture[0] = vec3(0.0F);
  picture[1] = vec3(-5.0F);
  picture[2] = vec3(std::numeric_limits<float>::infinity());
  picture[3] = vec3(std::numeric_limits<float>::quiet_NaN());
  picture[4] = vec3(1.0e6F);
  EXPECT_NEAR(autoExposure(picture), 0.0, kRoundoff);
}

TEST(AutoExposure, OfABlackPictureIsNought) {
  EXPECT_EQ(autoExposure(std::vector<vec3>(10, vec3(0.0F))), 0.0);
  EXPECT_EQ(autoExposure({}), 0.0);
}

}  // namespace
}  // namespace soffit::color
