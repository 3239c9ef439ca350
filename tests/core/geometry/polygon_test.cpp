// SPDX-License-Identifier: MIT
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/rng.h"

namespace soffit::geometry {
namespace {

dvec3 vectorArea(const dvec3& a, const dvec3& b, const dvec3& c) {
  return 0.5 * glm::cross(b - a, c - a);
}

// The triangles number n - 2, all face as the polygon does, and their areas add up to `area`:
// they cover it once.
void expectCover(const std::vector<dvec3>& polygon, const dvec3& facing, double area) {
  const std::vector<uvec3> triangles = triangulatePolygon(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const uvec3& t : triangles) {
    const double part = glm::dot(vectorArea(polygon[t.x], polygon[t.y], polygon[t.z]), facing);
    EXPECT_GE(part, -1e-15 * area);  // round-off; triangles without area may be needed
    sum += part;
  }
  EXPECT_NEAR(sum, area, 1e-12 * area);  // round-off
}

const std::vector<dvec2> kComb{{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {5, 1}, {5, 3}, {4, 3},
                               {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Polygon, ConcaveOnesAreCutInAnyPlaneAndOrder) {
  for (const dvec3& turn :
       {dvec3(0.0), dvec3(90, 0, 0), dvec3(0, 90, 0), dvec3(180, 0, 0), dvec3(33, 44, 55)}) {
    const dmat3 rotation = rotationXyz(turn);
    for (std::size_t start = 0; start < kComb.size(); ++start) {
      std::vector<dvec3> polygon;
      for (std::size_t i = 0; i < kComb.size(); ++i) {
        const dvec2 p = kComb[(start + i) % kComb.size()];
        polygon.push_back(rotation * dvec3(p.x, p.y, 2.0) + dvec3(1e3, -1e3, 0));
      }
      expectCover(polygon, rotation * dvec3(0, 0, 1), 7 + 4 * 2);
    }
  }
}

TEST(Polygon, AHoleTiedInByASlitStaysOpen) {
  const std::vector<dvec3> wall{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 0},
                                {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  expectCover(wall, {0, 0, 1}, 12 - 1);
}

TEST(Polygon, QuadsUseAValidDiagonalAndTheShorterOfTwo) {
  const std::vector<dvec3> arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (std::size_t start = 0; start < 4; ++start) {
    std::vector<dvec3> turned;
    for (std::size_t i = 0; i < 4; ++i) turned.push_back(arrow[(start + i) % 4]);
    expectCover(turned, {0, 0, 1}, 1.0);
  }
  const std::vector<dvec3> kite{{0, 0, 0}, {3, -1, 0}, {6, 0, 0}, {3, 1, 0}};
  EXPECT_EQ(triangulatePolygon(kite), (std::vector<uvec3>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Polygon, RegularOnesHaveTheirArea) {
  for (const int n : {3, 5, 100}) {
    std::vector<dvec3> polygon;
    for (int i = 0; i < n; ++i) {
      const double phi = 2 * kPi * i / n;
      polygon.emplace_back(std::cos(phi), std::sin(phi), 0.0);
    }
    expectCover(polygon, {0, 0, 1}, 0.5 * n * std::sin(2 * kPi / n));
  }
}

TEST(Polygon, NonsenseEndsAndKeepsItsCount) {
  Rng rng(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t n = 5; n < 40; ++n) {
    std::vector<dvec3> polygon(n);
    for (dvec3& p : polygon) p = {rng.uniform(), rng.uniform(), rng.uniform()};
    if (n % 3 == 0) polygon[n / 2].x = nan;
    if (n % 5 == 0) polygon.assign(n, dvec3(1.0));
    const std::vector<uvec3> triangles = triangulatePolygon(polygon);
    ASSERT_EQ(triangles.size(), n - 2);
    for (const uvec3& t : triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), n);
  }
  std::vector<dvec3> tangle(3000);  // must not take the cube of its corners
  for (dvec3& p : tangle) p = {rng.uniform(), rng.uniform(), 0.0};
  EXPECT_EQ(triangulatePolygon(tangle).size(), 2998U);
  EXPECT_TRUE(triangulatePolygon(std::vector<dvec3>(2)).empty());
  EXPECT_EQ(triangulatePolygon(std::vector<dvec3>(40000)).size(), 39998U);
}

}  // namespace
}  // namespace soffit::geometry
