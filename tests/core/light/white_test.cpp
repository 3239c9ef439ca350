// SPDX-License-Identifier: MIT
#include "core/light/white.h"

#include <gtest/gtest.h>

#include <vector>

namespace soffit::light {
namespace {

Luminaire lamp(double kelvin, double flux) {
  Luminaire l;
  l.colour.cct_k = kelvin;
  l.flux = flux;
  return l;
}

TEST(WhiteOf, OneColourIsItself) {
  const std::vector<Luminaire> lamps{lamp(2700.0, 800.0), lamp(2700.0, 1200.0)};
  EXPECT_NEAR(whiteOf(lamps), 2700.0, 1.0);
}

TEST(WhiteOf, LiesBetweenTwoColoursNearTheStronger) {
  const std::vector<Luminaire> even{lamp(2700.0, 1000.0), lamp(5000.0, 1000.0)};
  const std::vector<Luminaire> cool{lamp(2700.0, 100.0), lamp(5000.0, 1000.0)};
  EXPECT_GT(whiteOf(even), 2900.0);
  EXPECT_LT(whiteOf(even), 4200.0);
  EXPECT_GT(whiteOf(cool), whiteOf(even));
  EXPECT_LT(whiteOf(cool), 5000.0);
}

TEST(WhiteOf, WhatIsOffOrDimmedToNothingDoesNotCount) {
  std::vector<Luminaire> lamps{lamp(2700.0, 1000.0), lamp(5000.0, 1000.0), lamp(6000.0, 500.0)};
  lamps[1].on = false;
  lamps[2].dimming = 0.0;
  EXPECT_NEAR(whiteOf(lamps), 2700.0, 1.0);
}

TEST(WhiteOf, NoneForDaylightAndDarkness) {
  EXPECT_EQ(whiteOf({}), 0.0);
  Luminaire daylight;
  daylight.flux = 1000.0;
  const std::vector<Luminaire> lamps{daylight};
  EXPECT_EQ(whiteOf(lamps), 0.0);
}

}  // namespace
}  // namespace soffit::light
