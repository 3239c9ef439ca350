// SPDX-License-Identifier: MIT
#include "core/prt/texture_layout.h"

#include "core/prt/texel_raster.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

TextureLayout layoutOf(const Surfaces& s, const TextureOptions& options) {
  std::vector<std::uint32_t> all(s.triangleCount());
  std::iota(all.begin(), all.end(), 0U);
  return layOut(s, all, options);
}

Builder lumber() {
  Builder b;
  b.add(geometry::makeBox({0, 0, 0}, {1, 2, 3}), matte(vec3(0.5F)));
  b.add(geometry::makeSphere({5, 0, 0}, 0.7F, 8), matte(vec3(0.5F)));
  b.add(geometry::makeRectangle(3, 0.3F), matte(vec3(0.5F)));
  return b;
}

double receivingArea(const Surfaces& s) {
  double area = 0.0;
  for (std::size_t t = 0; t < s.triangleCount(); ++t) {
    area += double{s.areas[t]} * ((s.sides[t] & 1) + (s.sides[t] >> 1));
  }
  return area;
}

TEST(TextureLayout, AreasOfTexelsSumToAllSides) {
  const auto surfaces = lumber().surfaces();
  for (const double texel : {0.3, 0.11, 0.04}) {
    const TextureLayout layout = layoutOf(*surfaces, {.texel = texel, .given_uvs = false});
    double area = 0.0;
    for (const RasterTexel& t : rasterize(*surfaces, layout)) area += double{t.area};
    EXPECT_NEAR(area, receivingArea(*surfaces), 1e-5 * area) << texel;
  }
}

TEST(TextureLayout, EveryTexelHasOnePointOnItsTriangleAndIsSortedOnce) {
  const auto surfaces = lumber().surfaces();
  const TextureLayout layout = layoutOf(*surfaces, {.texel = 0.1, .given_uvs = false});
  const auto texels = rasterize(*surfaces, layout);
  ASSERT_GT(texels.size(), 1000U);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const RasterTexel& t = texels[i];
    if (i > 0) {
      ASSERT_LT(texels[i - 1].texel, t.texel);
    }
    EXPECT_GE(t.u, 0.0F);
    EXPECT_GE(t.v, 0.0F);
    EXPECT_LE(t.u + t.v, 1.00001F);
    EXPECT_TRUE(surfaces->receives(t.triangle, t.front));
    EXPECT_GT(t.coverage, 0.0F);
    EXPECT_LE(t.coverage, 1.0F);
  }
}

TEST(TextureLayout, ChartsKeepTheirDistanceOnEveryLevel) {
  const auto surfaces = lumber().surfaces();
  for (const int levels : {1, 3, 4}) {
    const TextureLayout layout =
        layoutOf(*surfaces, {.texel = 0.1, .levels = levels, .given_uvs = false});
    EXPECT_EQ(layout.width % (1 << (levels - 1)), 0);
    const auto texels = rasterize(*surfaces, layout);
    for (int level = 0; level < levels; ++level) {
      std::map<std::pair<int, int>, std::uint32_t> chart;
      for (const RasterTexel& t : texels) {
        const int x = static_cast<int>(t.texel) % layout.width >> level;
        const int y = static_cast<int>(t.texel) / layout.width >> level;
        const auto [it, added] = chart.try_emplace({x, y}, t.chart);
        EXPECT_EQ(it->second, t.chart);
      }
      for (const auto& [at, c] : chart) {
        for (int dy = -2; dy <= 2; ++dy) {
          for (int dx = -2; dx <= 2; ++dx) {
            const auto it = chart.find({at.first + dx, at.second + dy});
            if (it != chart.end()) {
              EXPECT_EQ(it->second, c) << "level " << level;
            }
          }
        }
      }
    }
  }
}

TEST(TextureLayout, ASideIsFilled) {
  const auto surfaces = lumber().surfaces();
  for (const int side : {64, 256}) {
    const TextureLayout layout = layoutOf(*surfaces, {.side = side, .given_uvs = false});
    EXPECT_LE(std::max(layout.width, layout.height), side);
    EXPECT_GE(std::max(layout.width, layout.height), 0.9 * side);
  }
  const TextureLayout small =
      layoutOf(*surfaces, {.texel = 0.001, .most_side = 128, .given_uvs = false});
  EXPECT_LE(std::max(small.width, small.height), 128);
  EXPECT_GT(small.texel, 0.01);
}

geometry::Mesh mappedQuad(const vec2& lo, const vec2& hi) {
  geometry::Mesh mesh = testing::quad({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  mesh.uvs = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
  return mesh;
}

TEST(TextureLayout, GivenCoordinatesServeWhereTheyAreOneToOne) {
  const TextureOptions options{.texel = 0.1};
  const auto layout = [&](const vec2& lo, const vec2& hi) {
    return layoutOf(*Builder().add(mappedQuad(lo, hi), matte(vec3(0.5F))).surfaces(), options);
  };
  EXPECT_TRUE(layout({0, 0}, {1, 1}).given_uvs);
  EXPECT_EQ(layout({0, 0}, {1, 1}).width, 40);  // both sides, beside one another
  EXPECT_EQ(layout({0, 0}, {1, 1}).height, 20);
  EXPECT_EQ(layout({0, 0}, {0.5F, 0.5F}).height, 40);
  EXPECT_FALSE(layout({0, 0}, {3, 3}).given_uvs);  // repeated
  EXPECT_FALSE(layout({0, 0}, {0, 0}).given_uvs);  // none
  // Two quads on one another.
  Builder twice;
  twice.add(mappedQuad({0, 0}, {1, 1}), matte(vec3(0.5F)));
  twice.add(testing::moved(mappedQuad({0.5F, 0}, {1, 1}), {5, 0, 0}), matte(vec3(0.5F)));
  EXPECT_FALSE(layoutOf(*twice.surfaces(), options).given_uvs);
}

TEST(TextureLayout, MirroredCoordinatesServe) {
  const auto surfaces = Builder().add(mappedQuad({1, 0}, {0, 1}), matte(vec3(0.5F))).surfaces();
  const TextureLayout layout = layoutOf(*surfaces, {.texel = 0.1});
  EXPECT_TRUE(layout.given_uvs);
  double area = 0.0;
  for (const RasterTexel& t : rasterize(*surfaces, layout)) area += double{t.area};
  EXPECT_NEAR(area, 8.0, 1e-5);
}

TEST(TextureLayout, ThinTrianglesCostNoPointOnTheEdge) {
  // A right triangle whose hypotenuse cuts texels anyhow: points keep off it.
  geometry::Mesh mesh = testing::quad({0, 0, 0}, {3.03F, 0, 0}, {0, 1.77F, 0});
  mesh.triangles.pop_back();
  const auto surfaces = Builder().add(mesh, matte(vec3(0.5F))).surfaces();
  const TextureLayout layout = layoutOf(*surfaces, {.texel = 0.1, .given_uvs = false});
  for (const RasterTexel& t : rasterize(*surfaces, layout)) {
    const float least = std::min({t.u, t.v, 1.0F - t.u - t.v});
    EXPECT_TRUE(least > 1e-3F || t.coverage > 0.4F);
  }
}

TEST(TextureLayout, WhatReceivesNothingTakesNoTexels) {
  const TextureLayout layout = layoutOf(*Builder().surfaces(), {});
  EXPECT_EQ(layout.width, 0);
  EXPECT_TRUE(layout.triangles.empty());
}

}  // namespace
}  // namespace soffit::prt
