// SPDX-License-Identifier: MIT
#include "core/render/line_labels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

LuxPicture pictureOf(int width, int height, auto f) {
  LuxPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.lux.push_back(f(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
    }
  }
  return picture;
}

const std::vector<double> kLevels{100.0, 200.0, 300.0};

TEST(LineLabels, LieOnTheirLinesAndApart) {
  const auto picture = pictureOf(400, 300, [](float x, float) { return x; });
  const LabelRoom room{{40.0F, 16.0F}, 120.0F};
  const auto labels = placeLineLabels(picture, kLevels, room);
  ASSERT_GE(labels.size(), 6U);
  for (const LineLabel& label : labels) {
    EXPECT_NEAR(static_cast<double>(label.at.x), label.level, 1e-3);  // float round-off
    for (const LineLabel& other : labels) {
      if (&label == &other) continue;
      const vec2 way = glm::abs(label.at - other.at);
      EXPECT_TRUE(way.x >= room.size.x || way.y >= room.size.y);
      if (label.level == other.level) {
        EXPECT_GE(glm::length(way), room.repeat);
      }
    }
  }
}

TEST(LineLabels, LinesThatLieCloseGetNone) {
  const auto picture = pictureOf(400, 300, [](float x, float) { return 10.0F * x; });
  EXPECT_TRUE(placeLineLabels(picture, kLevels, {}).empty());
}

TEST(LineLabels, EdgesOfSurfacesAreNoLines) {
  const auto step =
      pictureOf(400, 300, [](float x, float) { return x < 200.0F ? 150.0F : 250.0F; });
  EXPECT_TRUE(placeLineLabels(step, kLevels, {}).empty());
  // Slopes on both sides of an edge that lies between two levels.
  const auto ridge = pictureOf(400, 300, [](float x, float) {
    return x < 200.0F ? 150.0F + 0.01F * x : 250.0F + 0.01F * x;
  });
  EXPECT_TRUE(placeLineLabels(ridge, kLevels, {}).empty());
}

TEST(LineLabels, NoneReachesBeyondASurface) {
  const auto picture = pictureOf(400, 300, [](float x, float y) { return y < 150.0F ? x : -2.0F; });
  for (const LineLabel& label : placeLineLabels(picture, kLevels, {})) {
    EXPECT_LT(label.at.y, 150.0F - 7.0F);
  }
  EXPECT_TRUE(placeLineLabels({}, kLevels, {}).empty());
  EXPECT_TRUE(placeLineLabels(picture, {}, {}).empty());
}

}  // namespace
}  // namespace soffit::render
