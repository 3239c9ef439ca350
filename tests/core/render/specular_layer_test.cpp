// SPDX-License-Identifier: MIT
#include "core/render/specular_layer.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

SpecularLayer floorLayer(int width, int height, float alpha) {
  SpecularLayer layer{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      layer.pixels.push_back({vec3(1.0F), 1.0F, vec3(x, y, 0), vec3(0, 0, 1), alpha, 0});
  return layer;
}

TEST(AddReflections, SumsUpAllPhasesOfABlockAlike) {
  // Each phase of the 4 x 4 block carries one unit once: any window must see the same mean.
  for (int phase = 0; phase < kPhases * kPhases; ++phase) {
    SpecularLayer layer = floorLayer(16, 16, 0.1F);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const bool lit = (y % kPhases) * kPhases + x % kPhases == phase;
        layer.pixels[static_cast<std::size_t>(y * 16 + x)].radiance = vec3(lit ? 16.0F : 0.0F);
      }
    }
    Film film(16, 16);
    addReflections(layer, film);
    for (int y = 2; y < 14; ++y)
      for (int x = 2; x < 14; ++x)
        EXPECT_NEAR(film.radiance[film.at(x, y)].y, 1.0F, 1e-5F);  // round-off
  }
}

TEST(AddReflections, LeavesMirrorsSharp) {
  SpecularLayer layer = floorLayer(8, 8, 0.0F);
  layer.pixels[27].radiance = vec3(5.0F);
  Film film(8, 8);
  addReflections(layer, film);
  EXPECT_EQ(film.radiance[27], vec3(5.0F));
  EXPECT_EQ(film.radiance[28], vec3(1.0F));
}

TEST(AddReflections, StaysOnTheSurface) {
  SpecularLayer layer = floorLayer(8, 8, 0.1F);
  for (int y = 0; y < 8; ++y) {
    for (int x = 4; x < 8; ++x) {
      auto& pixel = layer.pixels[static_cast<std::size_t>(y * 8 + x)];
      pixel.radiance = vec3(100.0F);
      if (y < 2) pixel.material = 1;                      // another material
      if (y >= 2 && y < 4) pixel.normal = vec3(1, 0, 0);  // another direction
      if (y >= 4 && y < 6) pixel.position.z = 10.0F;      // another plane
      if (y >= 6) pixel.coverage = 0.0F;                  // nothing that reflects
    }
  }
  Film film(8, 8);
  addReflections(layer, film);
  for (int y = 0; y < 8; ++y) EXPECT_EQ(film.radiance[film.at(3, y)], vec3(1.0F)) << y;
  EXPECT_EQ(film.radiance[film.at(7, 7)], vec3(0.0F));
}

TEST(AddReflections, CountsByCoverage) {
  SpecularLayer layer = floorLayer(1, 1, 0.3F);
  layer.pixels[0].coverage = 0.25F;
  layer.pixels[0].radiance = vec3(8.0F);
  Film film(1, 1);
  film.radiance[0] = vec3(3.0F);
  addReflections(layer, film);
  EXPECT_EQ(film.radiance[0], vec3(5.0F));
}

TEST(StandsAlone, WhereABlockHasNotOneLobe) {
  const SpecularLayer plain = floorLayer(12, 12, 0.2F);
  EXPECT_FALSE(standsAlone(plain, 6, 6));
  EXPECT_TRUE(standsAlone(plain, 0, 6));  // half of the block is beyond the picture
  // A cylinder: normals turn by a third of the lobe's width from column to column.
  SpecularLayer round = floorLayer(12, 12, 0.2F);
  for (std::size_t i = 0; i < round.pixels.size(); ++i) {
    const float turn = 0.06F * static_cast<float>(i % 12);
    round.pixels[i].normal = {std::sin(turn), 0.0F, std::cos(turn)};
    round.pixels[i].position = round.pixels[i].normal / 0.06F + vec3(0, i / 12, 0);
  }
  EXPECT_TRUE(standsAlone(round, 6, 6));
  for (auto& pixel : round.pixels) pixel.alpha = 0.8F;  // the same turn is little for a wide lobe
  EXPECT_FALSE(standsAlone(round, 6, 6));
  for (auto& pixel : round.pixels) pixel.alpha = 0.01F;  // nearly a mirror: never smoothed
  EXPECT_FALSE(standsAlone(round, 6, 6));
  EXPECT_FALSE(smooths(round, 6, 6));
}

TEST(AddReflections, LeavesWholePixelsAsTheyAre) {
  SpecularLayer layer = floorLayer(8, 8, 0.1F);
  layer.pixels[27].radiance = vec3(5.0F);
  layer.pixels[27].whole = true;
  Film film(8, 8);
  addReflections(layer, film);
  EXPECT_EQ(film.radiance[27], vec3(5.0F));
  EXPECT_EQ(film.radiance[28], vec3(1.0F));
  EXPECT_FALSE(standsAlone(layer, 3, 3));
}

}  // namespace
}  // namespace soffit::render
