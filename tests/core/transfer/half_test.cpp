// SPDX-License-Identifier: MIT
#include "core/transfer/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace soffit::transfer {
namespace {

TEST(Half, EveryOneComesBackFromFloat) {
  for (std::uint32_t bits = 0; bits <= 0xffffU; ++bits) {
    Half h;
    h.bits = static_cast<std::uint16_t>(bits);
    if (!h.finite()) continue;
    EXPECT_EQ(Half(static_cast<float>(h)).bits, bits);
  }
}

TEST(Half, IsTheNearestAndEvenOfTwo) {
  for (std::uint32_t bits = 0; bits < 0x7bffU; ++bits) {
    Half low;
    Half high;
    low.bits = static_cast<std::uint16_t>(bits);
    high.bits = static_cast<std::uint16_t>(bits + 1);
    const float middle = 0.5F * (static_cast<float>(low) + static_cast<float>(high));
    EXPECT_EQ(Half(middle).bits, bits % 2 == 0 ? bits : bits + 1);
    EXPECT_EQ(Half(std::nextafter(middle, 0.0F)).bits, bits);
    EXPECT_EQ(Half(std::nextafter(middle, 1e9F)).bits, bits + 1);
    EXPECT_EQ(Half(-std::nextafter(middle, 1e9F)).bits, 0x8000U + bits + 1);
  }
}

TEST(Half, KnownValuesAndTheEnds) {
  EXPECT_EQ(Half(1.0F).bits, 0x3c00U);
  EXPECT_EQ(Half(-2.0F).bits, 0xc000U);
  EXPECT_EQ(Half(65504.0F).bits, 0x7bffU);
  EXPECT_EQ(Half(0x1p-24F).bits, 1U);
  EXPECT_EQ(Half(1e-9F).bits, 0U);
  EXPECT_EQ(static_cast<float>(Half(1e9F)), 65504.0F);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(static_cast<float>(Half(-infinity)), -infinity);
  EXPECT_FALSE(Half(infinity).finite());
  EXPECT_TRUE(std::isnan(static_cast<float>(Half(std::numeric_limits<float>::quiet_NaN()))));
}

}  // namespace
}  // namespace soffit::transfer
