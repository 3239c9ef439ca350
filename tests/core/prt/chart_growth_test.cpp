// SPDX-License-Identifier: MIT
#include "core/prt/chart_growth.h"

#include "core/prt/flat_cover.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

std::vector<FlatChart> chartsOf(const Surfaces& s, const GrowthOptions& options = {}) {
  std::vector<std::uint32_t> all(s.triangleCount());
  std::iota(all.begin(), all.end(), 0U);
  return growCharts(s, all, options);
}

double flatArea(const std::array<vec2, 3>& c) {
  const vec2 a = c[1] - c[0];
  const vec2 b = c[2] - c[0];
  return 0.5 * (double{a.x} * b.y - double{a.y} * b.x);
}

/// Every triangle once, none turned over, none on another.
void expectSound(const Surfaces& s, const std::vector<FlatChart>& charts) {
  std::vector<int> count(s.triangleCount(), 0);
  for (const FlatChart& chart : charts) {
    FlatCover cover(chart.size, 0.01F);
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      ++count[chart.triangles[i]];
      EXPECT_GT(flatArea(chart.corners[i]), 0.0);
      EXPECT_TRUE(cover.claim(chart.corners[i]));
      for (const vec2& c : chart.corners[i]) {
        EXPECT_GE(std::min(c.x, c.y), -1e-5F);
        EXPECT_LE(c.x, chart.size.x + 1e-5F);
        EXPECT_LE(c.y, chart.size.y + 1e-5F);
      }
    }
  }
  EXPECT_TRUE(std::all_of(count.begin(), count.end(), [](int n) { return n == 1; }));
}

TEST(ChartGrowth, ABoxIsSixRectanglesWhicheverWayItIsTurned) {
  for (const dvec3& turn : {dvec3(0), dvec3(20, 50, 70)}) {
    const auto box = testing::turned(geometry::makeBox({0, 0, 0}, {1, 2, 3}), turn);
    const auto surfaces = Builder().add(box, matte(vec3(0.5F))).surfaces();
    const auto charts = chartsOf(*surfaces);
    ASSERT_EQ(charts.size(), 6U);
    expectSound(*surfaces, charts);
    double area = 0.0;
    for (const FlatChart& chart : charts) {
      for (const auto& c : chart.corners) area += flatArea(c);
    }
    EXPECT_NEAR(area, 22.0, 1e-4);
    if (turn == dvec3(0)) {
      EXPECT_NEAR(double{charts[0].size.x} * charts[0].size.y, 6.0, 1e-5);
    }
  }
}

TEST(ChartGrowth, SmoothSurfacesBendWithinTheCone) {
  const auto surfaces =
      Builder().add(geometry::makeSphere({3, 1, 2}, 1.0F, 16), matte(vec3(0.5F))).surfaces();
  const auto charts = chartsOf(*surfaces);
  expectSound(*surfaces, charts);
  EXPECT_LT(charts.size(), 40U);
  for (const FlatChart& chart : charts) {
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      const double shrunk = flatArea(chart.corners[i]) / surfaces->areas[chart.triangles[i]];
      EXPECT_GT(shrunk, std::cos(radians(80.0)));
      EXPECT_LT(shrunk, 1.0001);
    }
  }
}

TEST(ChartGrowth, ASpiralRampDoesNotLieOnItself) {
  // Three turns of a ramp, nearly level everywhere: one chart by its normals, but it would fold.
  geometry::Mesh ramp;
  const int steps = 96;
  for (int i = 0; i <= steps; ++i) {
    const double a = 3 * 2 * kPi * i / steps;
    for (const double r : {1.0, 2.0}) {
      ramp.positions.emplace_back(r * std::cos(a), r * std::sin(a), 0.01 * i);
      ramp.normals.emplace_back(0, 0, 1);
    }
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    ramp.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
    ramp.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
  }
  const auto surfaces = Builder().add(ramp, matte(vec3(0.5F))).surfaces();
  const auto charts = chartsOf(*surfaces);
  EXPECT_GE(charts.size(), 3U);
  EXPECT_LE(charts.size(), 6U);
  expectSound(*surfaces, charts);
}

TEST(ChartGrowth, MaterialsAndCreasesPart) {
  Builder b;
  b.add(testing::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), matte(vec3(0.5F)));
  b.add(testing::quad({1, 0, 0}, {1, 0, 0}, {0, 1, 0}), matte(vec3(0.3F)));
  b.add(testing::quad({2, 0, 0}, {1, 0, 0.2F}, {0, 1, 0}), matte(vec3(0.3F)));
  EXPECT_EQ(chartsOf(*b.surfaces()).size(), 3U);
}

TEST(FlatCover, NeighborsPassAndOverlapsDoNot) {
  FlatCover cover({1, 1}, 0.01F);
  EXPECT_TRUE(cover.claim({vec2(0, 0), vec2(1, 0), vec2(1, 1)}));
  EXPECT_TRUE(cover.claim({vec2(0, 0), vec2(1, 1), vec2(0, 1)}));
  EXPECT_FALSE(cover.claim({vec2(0.4F, 0.4F), vec2(0.6F, 0.4F), vec2(0.5F, 0.6F)}));
  FlatCover mirrored({1, 1}, 0.01F);
  EXPECT_TRUE(mirrored.claim({vec2(0, 0), vec2(1, 1), vec2(1, 0)}));
  EXPECT_FALSE(mirrored.claim({vec2(0, 0), vec2(1, 0), vec2(1, 1)}));
}

}  // namespace
}  // namespace soffit::prt
