// SPDX-License-Identifier: MIT
#include "core/render/stroke_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace soffit::render {
namespace {

bool same(const StrokeText& a, const StrokeText& b) {
  return a.width == b.width && a.strokes.size() == b.strokes.size() &&
         std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(),
                    [](const Stroke& s, const Stroke& t) { return s.a == t.a && s.b == t.b; });
}

TEST(StrokeFont, HasEveryPrintableSignOfAsciiWithinItsLine) {
  const StrokeText unknown = layOut("\x01");
  for (char c = '!'; c <= '~'; ++c) {
    const StrokeText sign = layOut(std::string(1, c));
    EXPECT_FALSE(same(sign, unknown)) << c;
    EXPECT_FALSE(sign.strokes.empty()) << c;
    for (const Stroke& s : sign.strokes) {
      for (const vec2& p : {s.a, s.b}) {
        // Curves may swing out a little between their points.
        EXPECT_GE(p.x, -1.0F) << c;
        EXPECT_LE(p.x, sign.width + 1.0F) << c;
        EXPECT_GE(p.y, -5.0F) << c;
        EXPECT_LE(p.y, kCapHeight + 2.0F) << c;
      }
    }
  }
}

TEST(StrokeFont, DigitsStandOnTheBaselineAndReachTheCapHeight) {
  for (char c = '0'; c <= '9'; ++c) {
    float low = 100.0F;
    float high = -100.0F;
    for (const Stroke& s : layOut(std::string(1, c)).strokes) {
      low = std::min({low, s.a.y, s.b.y});
      high = std::max({high, s.a.y, s.b.y});
    }
    EXPECT_NEAR(low, 0.0F, 0.5F) << c;
    EXPECT_NEAR(high, kCapHeight, 0.5F) << c;
  }
}

TEST(StrokeFont, LettersWithAccentsShowTheLetter) {
  EXPECT_TRUE(same(layOut("Büro"), layOut("Buro")));
  EXPECT_TRUE(same(layOut("\u201eA\u201c"), layOut("\"A\"")));
  EXPECT_FALSE(same(layOut("²"), layOut("2")));
}

TEST(StrokeFont, ShowsABoxForWhatItLacksAndForBrokenText) {
  const StrokeText box = layOut("\u4e2d");
  EXPECT_TRUE(same(layOut("\xff"), box));
  EXPECT_TRUE(same(layOut("\xe4\xb8"), box));
  EXPECT_TRUE(same(layOut("\xf0\x9f\x92\xa1"), box));
}

TEST(StrokeFont, GoesFromLeftToRight) {
  EXPECT_EQ(layOut("").width, 0.0F);
  EXPECT_GT(layOut("AA").width, 2 * layOut("A").width);
  EXPECT_GT(layOut("A A").width, layOut("AA").width);
}

}  // namespace
}  // namespace soffit::render
