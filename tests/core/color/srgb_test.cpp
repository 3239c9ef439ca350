// SPDX-License-Identifier: MIT
#include "core/color/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::color {
namespace {

TEST(Srgb, MeetsTheStandardsValues) {
  EXPECT_EQ(srgbEncode(0.0F), 0.0F);
  EXPECT_NEAR(srgbEncode(1.0F), 1.0F, 1e-6F);  // round-off of pow
  EXPECT_NEAR(srgbEncode(0.18F), 0.461356F, 1e-6F);
  EXPECT_NEAR(srgbDecode(0.5F), 0.214041F, 1e-6F);
}

TEST(Srgb, DecodingUndoesEncodingAlsoOutsideTheUnitRange) {
  for (const float v : {-2.0F, -0.001F, 0.0F, 0.001F, 0.0031308F, 0.02F, 0.5F, 1.0F, 7.0F}) {
    // A few operations and two pow of single precision.
    EXPECT_NEAR(srgbDecode(srgbEncode(v)), v,
                16 * std::numeric_limits<float>::epsilon() * std::max(1.0F, std::abs(v)));
  }
}

TEST(Srgb, KeepsNan) {
  EXPECT_TRUE(std::isnan(srgbEncode(std::nanf(""))));
}

}  // namespace
}  // namespace soffit::color
