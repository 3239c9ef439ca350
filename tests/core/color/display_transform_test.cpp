// SPDX-License-Identifier: MIT
#include "core/color/display_transform.h"

#include "core/base/parallel.h"
#include "core/color/display_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

namespace soffit::color {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path kConfig =
    std::filesystem::path(SOFFIT_SOURCE_DIR) / "resources/ocio/config.ocio";

DisplayTransform makeView(const std::string& view, const std::string& look = "") {
  auto made = DisplayTransform::create({.config = kConfig, .view = view, .look = look});
  EXPECT_TRUE(made.ok()) << made.error().message();
  return *made;
}

float grey(const DisplayTransform& view, float linear) {
  std::vector<vec3> pixel{vec3(linear)};
  view.apply(pixel);
  return pixel[0].y;
}

struct GreyCheck {
  const char* view;
  float at_018, at_1, at_16;
};

class Views : public testing::TestWithParam<GreyCheck> {};

TEST_P(Views, PlaceGreysAsPublished) {
  const DisplayTransform view = makeView(GetParam().view);
  // The figures are printed to three digits.
  EXPECT_NEAR(grey(view, 0.18F), GetParam().at_018, 6e-4F);
  EXPECT_NEAR(grey(view, 1.0F), GetParam().at_1, 6e-4F);
  EXPECT_NEAR(grey(view, 16.0F), GetParam().at_16, 6e-4F);
  EXPECT_NEAR(grey(view, 0.0F), 0.0F, 1e-8F);  // ACES leaves a rounding error of black
}

// The plain view leaves the display's own curve: powers, but for sRGB.
TEST(Displays, HaveTheirOwnCurves) {
  const auto shown = [](const char* display) {
    const auto made =
        DisplayTransform::create({.config = kConfig, .display = display, .view = "sRGB"});
    EXPECT_TRUE(made.ok()) << made.error().message();
    return grey(*made, 0.18F);
  };
  EXPECT_NEAR(shown("Gamma 2.2"), std::pow(0.18F, 1.0F / 2.2F), 1e-4F);
  EXPECT_NEAR(shown("Rec.1886"), std::pow(0.18F, 1.0F / 2.4F), 1e-4F);
  EXPECT_NEAR(shown("sRGB"), 1.055F * std::pow(0.18F, 1.0F / 2.4F) - 0.055F, 1e-4F);
}

TEST(Displays, AreNamedWithTheLooks) {
  const auto names = displaysOf(kConfig);
  ASSERT_TRUE(names.ok());
  EXPECT_THAT(names->displays, ElementsAre("sRGB", "Gamma 2.2", "Rec.1886"));
  EXPECT_THAT(names->looks, ElementsAre("Punchy", "Soft"));
  for (const std::string& display : names->displays) {
    EXPECT_EQ(*viewsOf(kConfig, display), *viewsOf(kConfig, "sRGB")) << display;
  }
}

TEST_P(Views, KeepGreyNeutralAndRiseFromBlackToWhite) {
  const DisplayTransform view = makeView(GetParam().view);
  float before = 0.0F;
  for (float stops = -16.0F; stops <= 10.0F; stops += 0.05F) {
    std::vector<vec3> pixel{vec3(std::exp2(stops))};
    view.apply(pixel);
    const vec3 p = pixel[0];
    // ACES' own matrices are neutral to four digits; ours to rounding.
    EXPECT_NEAR(p.x, p.y, 1e-3F) << stops;
    EXPECT_NEAR(p.z, p.y, 1e-3F) << stops;
    EXPECT_GE(p.y, before - 1e-6F) << stops;  // round-off of single precision tables
    before = p.y;
  }
  EXPECT_GT(before, 0.999F);
}

TEST_P(Views, NeverGiveNanNorLeaveTheDisplay) {
  const DisplayTransform view = makeView(GetParam().view);
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> values{kNan,  -kInf, -1.0F, -0.0F, 0.0F,  1e-42F,
                                  1e-6F, 0.5F,  3.0F,  1e4F,  3e38F, kInf};
  std::vector<vec3> pixels;
  for (const float r : values)
    for (const float g : values)
      for (const float b : values) pixels.emplace_back(r, g, b);
  view.apply(pixels);
  for (const vec3& p : pixels) {
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(p[c] >= 0.0F && p[c] <= 1.0F) << p[c];
  }
}

INSTANTIATE_TEST_SUITE_P(All, Views,
                         testing::Values(GreyCheck{"Filmic", 0.461F, 0.797F, 0.9995F},
                                         GreyCheck{"ACES", 0.356F, 0.812F, 0.9997F},
                                         GreyCheck{"sRGB", 0.461F, 1.0F, 1.0F},
                                         GreyCheck{"Reinhard", 0.427F, 0.737F, 1.0F}),
                         [](const auto& test) { return test.param.view; });

TEST(Filmic, HasASmoothCurve) {
  const DisplayTransform view = makeView("Filmic");
  // Code value over stops: the slope is greatest near grey and changes slowly.
  const auto code = [&](float stops) { return grey(view, 0.18F * std::exp2(stops)); };
  float slope = (code(-6.0F) - code(-6.25F)) / 0.25F;
  for (float stops = -6.0F; stops < 6.0F; stops += 0.25F) {
    const float next = (code(stops + 0.25F) - code(stops)) / 0.25F;
    EXPECT_GT(next, 0.0F);
    EXPECT_LT(std::abs(next - slope), 0.02F) << stops;
    slope = next;
  }
  EXPECT_NEAR((code(0.1F) - code(-0.1F)) / 0.2F, 0.16F, 0.002F);  // truncation of the difference
}

/// Hue angle in Oklab of a display colour, turns.
double hue(const vec3& code) {
  const auto decode = [](float y) {
    const double v = static_cast<double>(y);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double r = decode(code.x), g = decode(code.y), b = decode(code.z);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return std::atan2(0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
                    1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s) /
         (2 * 3.14159265358979);
}

/// Turn of the hue of warm light (about 3000 K on a wooden wall) over four stops, in turns.
double hueShift(const DisplayTransform& view) {
  const vec3 lamp(1.0F, 0.62F, 0.28F);
  std::vector<vec3> shown{lamp * 0.2F, lamp * 3.2F};
  view.apply(shown);
  return std::abs(hue(shown[0]) - hue(shown[1]));
}

TEST(Filmic, KeepsTheHueOfWarmLightOverExposure) {
  const double shift = hueShift(makeView("Filmic"));
  EXPECT_LT(shift, 0.014);  // 5 degrees; a design figure, not an error
  // A curve per channel without the detour through mixed primaries turns orange into yellow.
  EXPECT_LT(2 * shift, hueShift(makeView("Reinhard")));
}

TEST(DisplayTransform, AppliesExposureToLuminance) {
  const DisplayTransform view = makeView("sRGB");
  const std::vector<vec3> radiance{vec3(9.0F)};
  std::vector<vec3> out(1);
  view.apply(radiance, 1.0, out);  // 9 cd/m^2, one stop up, is 0.18
  EXPECT_NEAR(out[0].y, 0.461356F, 1e-5F);
}

TEST(DisplayTransform, DoesNotDependOnTheThreadCount) {
  const DisplayTransform view = makeView("ACES");
  std::vector<vec3> one(40000);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const float x = static_cast<float>(i) / 4000.0F;
    one[i] = {x, 0.5F * x, 1.0F / (x + 1.0F)};
  }
  std::vector<vec3> many = one;
  setThreadCount(1);
  view.apply(one);
  setThreadCount(0);
  view.apply(many);
  EXPECT_EQ(one, many);
}

TEST(DisplayTransform, LooksChangeContrastAboutMidGrey) {
  const DisplayTransform plain = makeView("Filmic");
  const DisplayTransform punchy = makeView("Filmic", "Punchy");
  const DisplayTransform soft = makeView("Filmic", "Soft");
  EXPECT_NEAR(grey(punchy, 0.18F), grey(plain, 0.18F), 1e-3F);  // four digits in the config
  EXPECT_NEAR(grey(soft, 0.18F), grey(plain, 0.18F), 1e-3F);
  EXPECT_GT(grey(punchy, 1.0F), grey(plain, 1.0F));
  EXPECT_LT(grey(soft, 1.0F), grey(plain, 1.0F));
}

TEST(DisplayTransform, SaysWhatTheConfigHasInsteadOfAnUnknownName) {
  const std::string at = kConfig.string();
  EXPECT_EQ(DisplayTransform::create({.config = kConfig, .view = "Magic"}).error().message(),
            at + ": the OCIO config has no view \"Magic\". It has: Filmic, ACES, sRGB, Reinhard, "
                 "False colour.");
  EXPECT_EQ(DisplayTransform::create({.config = kConfig, .display = "TV"}).error().message(),
            at + ": the OCIO config has no display \"TV\". It has: sRGB, Gamma 2.2, Rec.1886.");
  EXPECT_EQ(DisplayTransform::create({.config = kConfig, .look = "Noir"}).error().message(),
            at + ": the OCIO config has no look \"Noir\". It has: Punchy, Soft.");
}

TEST(DisplayTransform, SaysWhatIsWrongWithAConfig) {
  EXPECT_EQ(
      DisplayTransform::create({.config = "/nowhere/config.ocio"}).error().message(),
      "/nowhere/config.ocio: the OCIO config does not exist. Unset $OCIO to use Soffit's own, or "
      "let it name a config.ocio.");
  const auto broken = std::filesystem::temp_directory_path() / "soffit_broken_config.ocio";
  std::ofstream(broken) << "this: is: not a config";
  const auto failed = DisplayTransform::create({.config = broken});
  std::filesystem::remove(broken);
  ASSERT_FALSE(failed.ok());
  EXPECT_THAT(failed.error().message(), HasSubstr("the OCIO config cannot be read"));
}

TEST(DisplayTransform, SaysWhichViewMissesItsTable) {
  const auto lone = std::filesystem::temp_directory_path() / "soffit_lone_config.ocio";
  std::filesystem::copy_file(kConfig, lone, std::filesystem::copy_options::overwrite_existing);
  const auto failed = DisplayTransform::create({.config = lone});
  std::filesystem::remove(lone);
  ASSERT_FALSE(failed.ok());
  EXPECT_THAT(failed.error().message(),
              HasSubstr("the view \"Filmic\" of display \"sRGB\" cannot be built"));
}

TEST(DisplayConfig, IsFoundBesideTheProgramAndByTheEnvironment) {
  unsetenv("OCIO");
  unsetenv("SOFFIT_RESOURCES");
  const auto own = findDisplayConfig();
  ASSERT_TRUE(own.ok()) << own.error().message();
  EXPECT_TRUE(std::filesystem::equivalent(*own, kConfig));

  setenv("SOFFIT_RESOURCES", (std::string(SOFFIT_SOURCE_DIR) + "/resources").c_str(), 1);
  EXPECT_EQ(findDisplayConfig().value(), kConfig);
  setenv("SOFFIT_RESOURCES", "/nowhere", 1);
  EXPECT_EQ(
      findDisplayConfig().error().message(),
      "SOFFIT_RESOURCES=/nowhere: there is no ocio/config.ocio in this folder. Unset the variable, "
      "or let it name the folder that holds Soffit's resources.");
  setenv("OCIO", "/studio/config.ocio", 1);
  EXPECT_EQ(findDisplayConfig().value(), "/studio/config.ocio");
  unsetenv("OCIO");
  unsetenv("SOFFIT_RESOURCES");
  EXPECT_THAT(findResource("no/such.thing").error().message(), HasSubstr("Install Soffit again"));
}

TEST(DisplayConfig, ListsItsViews) {
  EXPECT_THAT(viewsOf(kConfig, "sRGB").value(),
              ElementsAre("Filmic", "ACES", "sRGB", "Reinhard", "Reinhard 2002",
                          "Tumblin-Rushmeier", "False colour"));
}

}  // namespace
}  // namespace soffit::color
