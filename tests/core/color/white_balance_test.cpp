// SPDX-License-Identifier: MIT
#include "core/color/white_balance.h"

#include "core/color/cct.h"
#include "core/color/display_shader.h"
#include "core/color/display_transform.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace soffit::color {
namespace {

constexpr dvec3 kLuminance{0.2126390058715104, 0.7151686787677560, 0.0721923153607336};

DisplayTransform viewFor(const char* view, double white) {
  DisplayChoice choice;
  choice.config = std::filesystem::path(SOFFIT_SOURCE_DIR) / "resources/ocio/config.ocio";
  choice.view = view;
  choice.white_balance = white;
  auto made = DisplayTransform::create(choice);
  EXPECT_TRUE(made.ok()) << made.error().message();
  return *made;
}

vec3 shown(const DisplayTransform& view, const dvec3& linear) {
  std::vector<vec3> pixel{vec3(linear)};
  view.apply(pixel);
  return pixel[0];
}

TEST(WhiteBalance, WhatTheLightMakesWhiteIsWhiteAndAsBright) {
  for (const double kelvin : {1500.0, 2700.0, 4000.0, 6500.0, 25000.0}) {
    const dvec3 lit = rec709FromXyz(planckianXyz(kelvin));
    const dvec3 seen = whiteBalance(kelvin) * lit;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 1.0, 1e-12) << kelvin;
    EXPECT_NEAR(glm::dot(seen, kLuminance), glm::dot(lit, kLuminance), 1e-12);
  }
}

TEST(WhiteBalance, ZeroIsDaylightAndChangesNothing) {
  EXPECT_EQ(whiteBalance(0.0), dmat3(1.0));
  EXPECT_EQ(whiteBalance(-1.0), dmat3(1.0));
}

// Bradford from illuminant A to D65, as B. Lindbloom publishes it (brucelindbloom.com, Chromatic
// Adaptation): XYZ to XYZ. Ours starts from the Planckian at A's temperature in the fit of cct.h.
TEST(WhiteBalance, IsTheBradfordMatrixOfIlluminantA) {
  const dmat3 published =
      glm::transpose(dmat3(0.8446965, -0.1179225, 0.3948108, -0.1366303, 1.1041226, 0.1291718,
                           0.0798489, -0.1348999, 3.1924009));
  const dmat3 ours = whiteBalance(2856.0);
  for (const dvec3& rgb : {dvec3(0.5, 0.4, 0.3), dvec3(0.2, 0.6, 0.1), dvec3(0.9, 0.3, 0.2)}) {
    const dvec3 seen = ours * rgb;
    const dvec3 expected = rec709FromXyz(published * xyzFromRec709(rgb));
    // The fit's white differs from A's by 0.003 in x and y; blue is the shortest cone's, threefold.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 0.02) << c;
  }
}

TEST(WhiteBalance, TemperatureOfABlackBodyIsFoundAgain) {
  for (double kelvin = 1600.0; kelvin < 20000.0; kelvin *= 1.13) {
    EXPECT_NEAR(correlatedTemperature(planckianXyz(kelvin)), kelvin, 1e-4 * kelvin) << kelvin;
  }
}

// CIE 15, table T.3: D50 and D65 beside the locus. The tolerance is that of the fit in cct.h.
TEST(WhiteBalance, TemperatureOfDaylightIsTheTabulatedOne) {
  EXPECT_NEAR(correlatedTemperature({0.96422, 1.0, 0.82521}), 5003.0, 60.0);
  EXPECT_NEAR(correlatedTemperature({0.95047, 1.0, 1.08883}), 6504.0, 100.0);
  EXPECT_NEAR(correlatedTemperature(planckianXyz(1400.0)), kWarmestWhite, 1.0);
}

TEST(WhiteBalance, AViewShowsLampLightAsGrey) {
  for (const char* view : {"Filmic", "ACES", "sRGB", "Reinhard"}) {
    const dvec3 lamp = 0.18 * rec709FromXyz(planckianXyz(3000.0));
    const vec3 warm = shown(viewFor(view, 0.0), lamp);
    const vec3 grey = shown(viewFor(view, 3000.0), lamp);
    const vec3 wanted = shown(viewFor(view, 0.0), dvec3(0.18));
    EXPECT_GT(warm.x, warm.z + 0.1F) << view;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(grey[c], wanted[c], 2e-4F) << view << c;
  }
}

TEST(WhiteBalance, SaturatedColoursStayInRange) {
  const DisplayTransform view = viewFor("Filmic", 1500.0);
  for (const dvec3& c : {dvec3(1, 0, 0), dvec3(0, 0, 8), dvec3(0, 1e6, 0)}) {
    const vec3 p = shown(view, c);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p[k], 0.0F);
      EXPECT_LE(p[k], 1.0F);
    }
  }
}

TEST(WhiteBalance, FalseColoursStayAsTheyAre) {
  const vec3 plain = shown(viewFor(kFalseColorView, 0.0), dvec3(0.5));
  EXPECT_EQ(shown(viewFor(kFalseColorView, 2700.0), dvec3(0.5)), plain);
}

}  // namespace
}  // namespace soffit::color
