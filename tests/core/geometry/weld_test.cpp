// SPDX-License-Identifier: MIT
#include "core/geometry/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/math/rng.h"

namespace soffit::geometry {
namespace {

TEST(Weld, EqualCoordinatesAreOnePoint) {
  const std::vector<vec3> points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0F, 0, 0}, {1, 2, 3.5F}};
  const std::vector<std::uint32_t> expected{0, 1, 0, 1, 4};
  EXPECT_EQ(weldPositions(points, 0.0F), expected);
  EXPECT_EQ(weldPositions(points, 1e-6F), expected);
}

TEST(Weld, PointsWithinTheToleranceAreOneAndOthersAreNot) {
  const std::vector<vec3> points{{1, 1, 1}, {1.09F, 1, 1}, {1.18F, 1, 1}, {1, 1, 0.905F}};
  // The third is near the second, but not near the point that stands for both.
  const std::vector<std::uint32_t> expected{0, 0, 2, 0};
  EXPECT_EQ(weldPositions(points, 0.1F), expected);
}

TEST(Weld, AgreesWithTheSearchOverAllPairs) {
  Rng rng(17);
  std::vector<vec3> points(800);
  for (vec3& p : points) p = vec3(rng.uniform(), rng.uniform(), rng.uniform()) - 0.5F;
  const float tolerance = 0.07F;
  const std::vector<std::uint32_t> fast = weldPositions(points, tolerance);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t slow = i;
    for (std::uint32_t j = 0; j < i && slow == i; ++j) {
      const dvec3 d = dvec3(points[i]) - dvec3(points[j]);
      if (fast[j] == j && glm::dot(d, d) <= double{tolerance} * tolerance) slow = j;
    }
    ASSERT_EQ(fast[i], slow);
  }
}

TEST(Weld, WhatIsNoNumberStaysAlone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<vec3> points{{nan, 0, 0}, {nan, 0, 0}, {inf, 0, 0}, {inf, 0, 0}};
  const std::vector<std::uint32_t> expected{0, 1, 2, 3};
  EXPECT_EQ(weldPositions(points, 0.1F), expected);
}

TEST(Weld, ToleranceIsTwoUnitsInTheLastPlaceOfTheLargestCoordinate) {
  Box box;
  EXPECT_EQ(weldTolerance(box), 0.0F);
  box.add({-1, 2, 3});
  box.add({-8, 1, 1});
  EXPECT_EQ(weldTolerance(box), 8 * 0x1p-22F);
}

}  // namespace
}  // namespace soffit::geometry
