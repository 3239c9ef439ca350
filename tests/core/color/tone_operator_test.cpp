// SPDX-License-Identifier: MIT
#include "core/color/tone_operator.h"

#include "core/color/display_transform.h"
#include "core/color/exposure.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <vector>

namespace soffit::color {
namespace {

const std::filesystem::path kConfig =
    std::filesystem::path(SOFFIT_SOURCE_DIR) / "resources/ocio/config.ocio";

float linear(double luminance) {
  return static_cast<float>(luminance / kReferenceLuminance);
}

TEST(ToneOperator, ReinhardTakesTheLogAverageToTheKey) {
  const PictureLuminance room{.log_average = 25.0, .least = 1.0, .most = 3000.0};
  const ToneOperator tone =
      makeToneOperator(ToneKind::reinhard_2002, room, {.key = 0.18, .white = 1e6});
  // Equation 3: s / (1 + s), without a white point.
  EXPECT_NEAR(tone.displayed(linear(25.0)), 0.18 / 1.18, 1e-6);
  EXPECT_NEAR(tone.displayed(linear(2500.0)), 18.0 / 19.0, 1e-6);
  // Equation 4: what is as bright as the white point is white.
  const ToneOperator burnt =
      makeToneOperator(ToneKind::reinhard_2002, room, {.key = 0.18, .white = 2.0});
  EXPECT_NEAR(burnt.displayed(linear(25.0 * 2.0 / 0.18)), 1.0, 1e-5);
}

TEST(ToneOperator, ReinhardFindsKeyAndWhiteFromThePicture) {
  // Log-average in the middle of the range: a middle key. 2^10 : 1, white 1.5 * 2^5.
  const ToneOperator middle = makeToneOperator(ToneKind::reinhard_2002,
                                               {.log_average = 32.0, .least = 1.0, .most = 1024.0});
  EXPECT_NEAR(middle.a, 0.18 * 100.0 / 32.0, 1e-6);
  EXPECT_NEAR(middle.b, 1.0 / (48.0 * 48.0), 1e-8);
  // Near the top, a high key: 4^(1/2) times.
  const ToneOperator high = makeToneOperator(
      ToneKind::reinhard_2002, {.log_average = std::exp2(7.5), .least = 1.0, .most = 1024.0});
  EXPECT_NEAR(high.a * std::exp2(7.5) / 100.0, 0.36, 1e-6);
}

TEST(ToneOperator, TumblinRushmeierShowsTheAdaptationOfTheEye) {
  // A world as bright as the display's own adaptation: shown as it is, contrast unchanged.
  const double own = 100.0 / std::sqrt(35.0);
  const ToneOperator same =
      makeToneOperator(ToneKind::tumblin_rushmeier, {.log_average = own, .least = 1, .most = 100});
  EXPECT_NEAR(same.b, 1.0, 1e-6);
  EXPECT_NEAR(same.displayed(linear(own)), own / 100.0, 1e-4);
  EXPECT_NEAR(same.displayed(linear(3.0 * own)), 3.0 * own / 100.0, 3e-4);
  // At night contrasts are weaker and all is darker; by day they are stronger and brighter.
  const ToneOperator night = makeToneOperator(ToneKind::tumblin_rushmeier,
                                              {.log_average = 0.01, .least = 1e-4, .most = 1});
  const ToneOperator day = makeToneOperator(ToneKind::tumblin_rushmeier,
                                            {.log_average = 5000, .least = 10, .most = 1e5});
  EXPECT_LT(night.b, 0.6F);
  EXPECT_GT(day.b, 1.05F);
  EXPECT_LT(night.displayed(linear(0.01)), 0.5F * same.displayed(linear(own)));
  EXPECT_GT(day.displayed(linear(5000.0)), 1.1F * same.displayed(linear(own)));
}

TEST(ToneOperator, KeepsTheChromaticityAndRises) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> u(0.0F, 1.0F);
  for (const ToneKind kind : {ToneKind::reinhard_2002, ToneKind::tumblin_rushmeier}) {
    const ToneOperator tone = makeToneOperator(kind, {.log_average = 40, .least = 2, .most = 900});
    for (int i = 0; i < 200; ++i) {
      const vec3 rgb = vec3(u(rng), u(rng), u(rng)) * std::exp2(20.0F * u(rng) - 10.0F);
      const vec3 shown = tone.displayed(rgb);
      EXPECT_NEAR(luminance(shown), tone.displayed(luminance(rgb)), 2e-6F * luminance(shown));
      EXPECT_NEAR(shown.x * rgb.y, shown.y * rgb.x, 1e-5F * shown.x * rgb.y + 1e-12F);
      EXPECT_GT(tone.displayed(1.01F * luminance(rgb)), tone.displayed(luminance(rgb)));
    }
    EXPECT_EQ(tone.displayed(vec3(0.0F)), vec3(0.0F));
    EXPECT_EQ(tone.displayed(-1.0F), 0.0F);
    EXPECT_EQ(tone.displayed(std::numeric_limits<float>::quiet_NaN()), 0.0F);
    EXPECT_TRUE(std::isfinite(tone.displayed(std::numeric_limits<float>::infinity())));
  }
}

TEST(PictureLuminance, LeavesOutThePercentAtEitherEndAndWhatIsNoLight) {
  std::vector<vec3> picture(1000, vec3(50.0F));
  for (std::size_t i = 0; i < 9; ++i) picture[i] = vec3(1e6F);  // a luminaire
  picture[20] = vec3(0.0F);
  picture[21] = vec3(-4.0F);
  picture[22] = vec3(std::numeric_limits<float>::quiet_NaN());
  const PictureLuminance found = pictureLuminance(picture);
  EXPECT_NEAR(found.log_average, 50.0, 1e-3);
  EXPECT_NEAR(found.most, 50.0, 1e-3);
  EXPECT_EQ(pictureLuminance({}).log_average, PictureLuminance{}.log_average);
  const std::vector<vec3> black(10, vec3(0.0F));
  EXPECT_EQ(pictureLuminance(black).least, PictureLuminance{}.least);
}

TEST(PictureLuminance, ManyPicturesAreKnownFromFewPixels) {
  std::mt19937 rng(3);
  std::normal_distribution<float> stops(5.0F, 2.0F);
  std::vector<vec3> picture(200000);
  for (vec3& p : picture) p = vec3(std::exp2(stops(rng)));
  const PictureLuminance all = pictureLuminance(picture);
  const PictureLuminance few = pictureLuminance(picture, 17);
  // 11,800 of them: two stops / sqrt(n) is 0.018 stops of standard error.
  EXPECT_NEAR(std::log2(few.log_average), std::log2(all.log_average), 0.08);
}

TEST(AdaptingViews, EndInTheDisplaysCodeValues) {
  for (const char* view : {kReinhard2002View, kTumblinRushmeierView}) {
    DisplayChoice choice{.config = kConfig, .view = view};
    choice.tone =
        makeToneOperator(*toneKindOf(view), {.log_average = 30, .least = 1, .most = 2000});
    const auto transform = DisplayTransform::create(choice);
    ASSERT_TRUE(transform.ok()) << transform.error().message();
    std::vector<vec3> out(3);
    const std::vector<vec3> in{vec3(30.0F), vec3(120.0F, 80.0F, 20.0F), vec3(1e7F)};
    transform->apply(in, 0.0, out);
    for (std::size_t i = 0; i < 2; ++i) {
      const vec3 shown = choice.tone.displayed(in[i] * exposureScale(0.0));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(out[i][c], srgbEncode(std::min(shown[c], 1.0F)), 1.0F / 512.0F) << view;
      }
    }
    EXPECT_NEAR(out[2].x, 1.0F, 1e-3F);
  }
}

}  // namespace
}  // namespace soffit::color
