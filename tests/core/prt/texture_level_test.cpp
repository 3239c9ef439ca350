// SPDX-License-Identifier: MIT
#include "core/prt/texture_level.h"

#include "core/math/rng.h"
#include "tests/core/prt/scenes.h"

#include "core/prt/texture_receivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

TEST(TextureLevel, DilationRepeatsTheNearestTexel) {
  // One texel in the middle of 9 x 9.
  for (const int rings : {0, 1, 3}) {
    const TextureLevel level = finestLevel(9, 9, {40}, {1.0F}, rings);
    const auto dilated = std::count(level.kind.begin(), level.kind.end(), TexelKind::dilated);
    const int side = 2 * rings + 1;
    EXPECT_EQ(dilated, side * side - 1);
    EXPECT_EQ(std::count(level.item.begin(), level.item.end(), 0U), side * side);
  }
  // Beyond the texture's border there is nothing.
  const TextureLevel corner = finestLevel(4, 4, {0}, {1.0F}, 2);
  EXPECT_EQ(std::count(corner.item.begin(), corner.item.end(), 0U), 9);
}

TEST(TextureLevel, CoarserTexelsAreMeansByArea) {
  // Two texels of a block of four are covered, one of them to a third.
  const TextureLevel fine = finestLevel(4, 2, {0, 1, 3}, {3.0F, 1.0F, 5.0F}, 0);
  const TextureLevel coarse = coarserLevel(fine, 0);
  ASSERT_EQ(coarse.items(), 2U);
  EXPECT_EQ(coarse.width, 2);
  EXPECT_EQ(coarse.height, 1);
  EXPECT_FLOAT_EQ(coarse.area[0], 4.0F);
  TransferRows rows(3, 2, 1);
  for (std::size_t i = 0; i < 3; ++i) rows.row(i)[2] = static_cast<float>(i + 1);
  const TransferRows means = coarserRows(coarse, rows);
  EXPECT_FLOAT_EQ(means.row(0)[2], 0.75F * 1.0F + 0.25F * 2.0F);
  EXPECT_FLOAT_EQ(means.row(1)[2], 3.0F);
}

TEST(TextureLevel, NoSeamIsDarkOnAnyLevel) {
  // Light of 1 everywhere is 1 wherever a surface is looked up, on every level.
  Builder b;
  b.add(testing::turned(geometry::makeBox({0, 0, 0}, {1, 2, 0.3F}), {10, 20, 30}),
        matte(vec3(0.5F)));
  b.add(geometry::makeSphere({4, 0, 0}, 0.5F, 8), matte(vec3(0.5F)));
  const auto surfaces = b.surfaces();
  const TextureReceivers all = TextureReceivers::atlas(surfaces, {.texel = 0.07, .levels = 4});
  const TextureSet& set = all.sets()[0];
  ASSERT_EQ(set.levels.size(), 4U);
  Rng rng(2);
  for (std::size_t k = 0; k < set.levels.size(); ++k) {
    const LightTexture texture =
        paint(set.levels[k], std::vector<vec3>(set.levels[k].items(), vec3(1.0F)));
    const float scale = std::ldexp(1.0F, -static_cast<int>(k));
    for (int i = 0; i < 3000; ++i) {
      geometry::Hit hit;
      hit.triangle = rng.below(static_cast<std::uint32_t>(surfaces->triangleCount()));
      hit.u = rng.uniform();
      hit.v = (1.0F - hit.u) * rng.uniform();
      vec2 place;
      ASSERT_TRUE(all.place(hit, true, place));
      EXPECT_NEAR(texture.at(scale * place).y, 1.0F, 1e-5F) << "level " << k;
    }
  }
}

TEST(TextureLevel, AreasStayOnEveryLevel) {
  const auto surfaces =
      Builder().add(geometry::makeSphere({4, 0, 0}, 0.5F, 8), matte(vec3(0.5F))).surfaces();
  const TextureReceivers all = TextureReceivers::atlas(surfaces, {.texel = 0.05, .levels = 4});
  double first = 0.0;
  for (const TextureLevel& level : all.sets()[0].levels) {
    const double sum = std::accumulate(level.area.begin(), level.area.end(), 0.0);
    first = first > 0.0 ? first : sum;
    EXPECT_NEAR(sum, first, 1e-5 * first);
  }
}

TEST(TextureLevel, EmptyTexelsCanBeColored) {
  const TextureLevel level = finestLevel(9, 1, {4}, {1.0F}, 2);
  const LightTexture texture = paint(level, std::vector<vec3>{vec3(2.0F)}, {1, 0, 1});
  EXPECT_EQ(texture.texels[0], vec3(1, 0, 1));
  EXPECT_EQ(texture.texels[2], vec3(2.0F));
  EXPECT_EQ(texture.at({3.7F, 0.5F}), vec3(2.0F));
}

}  // namespace
}  // namespace soffit::prt
