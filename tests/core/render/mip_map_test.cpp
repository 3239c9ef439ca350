// SPDX-License-Identifier: MIT
#include "core/render/mip_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::render {
namespace {

/// Two columns, two rows: red green / blue white, the first row at the top.
scene::Image fourTexels() {
  return {2, 2, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}};
}

TEST(MipMap, HasTheFirstRowAtTheTop) {
  const MipMap map(fourTexels());
  EXPECT_EQ(map.at({0.25F, 0.75F}, 1.0F), vec3(1, 0, 0));
  EXPECT_EQ(map.at({0.75F, 0.75F}, 1.0F), vec3(0, 1, 0));
  EXPECT_EQ(map.at({0.25F, 0.25F}, 1.0F), vec3(0, 0, 1));
}

TEST(MipMap, InterpolatesAndRepeats) {
  const MipMap map(fourTexels());
  EXPECT_EQ(map.at({0.5F, 0.75F}, 1.0F), vec3(0.5F, 0.5F, 0));
  EXPECT_EQ(map.at({0.0F, 0.75F}, 1.0F), vec3(0.5F, 0.5F, 0));  // across the border
  EXPECT_EQ(map.at({-2.75F, 7.75F}, 1.0F), map.at({0.25F, 0.75F}, 1.0F));
}

TEST(MipMap, ShowsTheMeanFromAfar) {
  const MipMap map(fourTexels());
  EXPECT_EQ(map.at({0.1F, 0.9F}, 100.0F), vec3(0.5F, 0.5F, 0.5F));
  // Sides that are no power of two keep the mean too, up to the weights of the odd rows.
  scene::Image odd{5, 3, 3, {}};
  for (int i = 0; i < 45; ++i) odd.pixels.push_back(0.4F);
  EXPECT_NEAR(MipMap(odd).at({0.3F, 0.3F}, 64.0F).x, 0.4F, 1e-6F);
}

TEST(MipMap, SurvivesCoordinatesThatAreNoNumbers) {
  const MipMap map(fourTexels());
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(map.at({kNan, 0.5F}, kNan), map.at({0.0F, 0.0F}, 1.0F));
}

}  // namespace
}  // namespace soffit::render
