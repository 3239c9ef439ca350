// SPDX-License-Identifier: MIT
#include "core/design/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace soffit::design {
namespace {

constexpr double kRoundoff = 1e-12;  // a quotient of numbers about 1

std::vector<double> sampled(int nu, int nv, auto f) {
  std::vector<double> values;
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i)
      values.push_back(f(static_cast<double>(i), static_cast<double>(j)));
  }
  return values;
}

TEST(Contours, OfAPlaneIsAStraightLineFromBorderToBorder) {
  const auto values = sampled(7, 5, [](double x, double y) { return x + 0.5 * y; });
  const auto lines = contoursAt(values, 7, 5, 3.25);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  for (const dvec2& p : lines[0].points) EXPECT_NEAR(p.x + 0.5 * p.y, 3.25, kRoundoff);
  const dvec2 a = lines[0].points.front();
  const dvec2 b = lines[0].points.back();
  EXPECT_NEAR(std::abs(a.y - b.y), 4.0, kRoundoff);
}

TEST(Contours, OfAPeakIsClosedAndConvergesToACircle) {
  // Truncation: linear edges of a quadratic function err by h^2 / 8 times its second derivative.
  double before = 0.0;
  for (const int n : {17, 33, 65}) {
    const double h = 2.0 / (n - 1);
    const auto values = sampled(n, n, [&](double i, double j) {
      const double x = i * h - 1.0;
      const double y = j * h - 1.0;
      return 1.0 - x * x - y * y;
    });
    const auto lines = contoursAt(values, n, n, 0.5);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    double worst = 0.0;
    for (const dvec2& p : lines[0].points) {
      worst = std::max(worst, std::abs(glm::length(h * p - dvec2(1.0)) - std::sqrt(0.5)));
    }
    EXPECT_LT(worst, 0.25 * h * h / (2.0 * std::sqrt(0.5)) * 1.01);
    // Second order, with room for where the grid happens to lie.
    if (before > 0.0) {
      EXPECT_LT(worst, 0.35 * before);
    }
    before = worst;
  }
}

TEST(Contours, ASaddleFollowsTheBilinearFunction) {
  // Saddle values (ac - bd) / (a + c - b - d) with a, c on one diagonal.
  const std::vector<double> high{3.0, 0.0, 0.0, 3.0};  // saddle at 1.5
  const auto joined = contoursAt(high, 2, 2, 1.0);
  ASSERT_EQ(joined.size(), 2U);
  // The diagonal of 3s stays connected: each line cuts off a corner with 0.
  for (const Contour& line : joined) {
    const dvec2 middle = 0.5 * (line.points.front() + line.points.back());
    EXPECT_GT(std::abs(middle.x - middle.y), 0.3);
  }
  const auto parted = contoursAt(high, 2, 2, 2.0);
  ASSERT_EQ(parted.size(), 2U);
  for (const Contour& line : parted) {
    const dvec2 middle = 0.5 * (line.points.front() + line.points.back());
    EXPECT_NEAR(middle.x, middle.y, kRoundoff);
  }
}

TEST(Contours, LinesOfARoughGridEndAtTheBorderOrNowhere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(0.0, 1.0);
  const auto values = sampled(23, 19, [&](double, double) { return height(random); });
  std::size_t points = 0;
  for (const Contour& line : contoursAt(values, 23, 19, 0.5)) {
    points += line.points.size();
    ASSERT_GE(line.points.size(), 2U);
    if (line.closed) continue;
    for (const dvec2& end : {line.points.front(), line.points.back()}) {
      EXPECT_TRUE(end.x == 0.0 || end.x == 22.0 || end.y == 0.0 || end.y == 18.0);
    }
  }
  // Each edge whose ends lie on different sides is crossed once.
  std::size_t crossed = 0;
  const auto above = [&](int i, int j) {
    return values[static_cast<std::size_t>(j * 23 + i)] >= 0.5;
  };
  for (int j = 0; j < 19; ++j) {
    for (int i = 0; i < 23; ++i) {
      if (i + 1 < 23) crossed += above(i, j) != above(i + 1, j) ? 1 : 0;
      if (j + 1 < 19) crossed += above(i, j) != above(i, j + 1) ? 1 : 0;
    }
  }
  EXPECT_EQ(points, crossed);
}

TEST(Contours, ThereAreNoneWhereNothingIsCrossed) {
  EXPECT_TRUE(contoursAt(std::vector<double>(12, 5.0), 4, 3, 5.0).empty());
  EXPECT_TRUE(contoursAt(std::vector<double>(12, 5.0), 4, 3, 6.0).empty());
  EXPECT_TRUE(contoursAt(std::vector<double>{1.0, 2.0, 3.0}, 3, 1, 1.5).empty());
  EXPECT_TRUE(contoursAt({}, 0, 0, 1.0).empty());
}

}  // namespace
}  // namespace soffit::design
