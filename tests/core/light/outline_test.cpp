// SPDX-License-Identifier: MIT
#include "core/light/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace soffit::light {
namespace {

constexpr double kRoundoff = 1e-14;  // a dozen operations on numbers of order 1

double coveredArea(const Outline& o) {
  double sum = 0.0;
  for (const uvec3& t : o.triangles) {
    const dvec2 u = o.corners[t.y] - o.corners[t.x];
    const dvec2 v = o.corners[t.z] - o.corners[t.x];
    sum += 0.5 * (u.x * v.y - u.y * v.x);
  }
  return sum;
}

TEST(Outline, TurnsAnyWindingCounterClockwise) {
  const std::vector<dvec2> ccw{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const std::vector<dvec2> cw(ccw.rbegin(), ccw.rend());
  for (const auto& polygon : {ccw, cw}) {
    const auto outline = makeOutline(polygon);
    ASSERT_TRUE(outline.ok());
    EXPECT_NEAR(outline->area, 2.0, kRoundoff);
    EXPECT_NEAR(coveredArea(*outline), 2.0, kRoundoff);
  }
}

TEST(Outline, CoversAnLShapeOnce) {
  const auto outline = makeOutline({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});
  ASSERT_TRUE(outline.ok());
  EXPECT_NEAR(outline->area, 4.0, kRoundoff);
  EXPECT_NEAR(coveredArea(*outline), 4.0, kRoundoff);
  EXPECT_EQ(outline->triangles.size(), 4U);
}

TEST(Outline, CoversAStar) {
  std::vector<dvec2> star;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1.0 : 0.3;
    star.emplace_back(r * std::cos(i * kPi / 5), r * std::sin(i * kPi / 5));
  }
  const auto outline = makeOutline(star);
  ASSERT_TRUE(outline.ok());
  EXPECT_NEAR(outline->area, 5 * 0.3 * std::sin(kPi / 5),
              kRoundoff);  // ten triangles of r1 r2 sin / 2
  EXPECT_NEAR(coveredArea(*outline), outline->area, kRoundoff);
}

TEST(Outline, AllowsAHoleJoinedByASlit) {
  const auto outline =
      makeOutline({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
  ASSERT_TRUE(outline.ok()) << outline.error().message();
  EXPECT_NEAR(outline->area, 8.0, kRoundoff);
  EXPECT_NEAR(coveredArea(*outline), 8.0, kRoundoff);
}

TEST(Outline, DropsRepeatedAndClosingCorners) {
  const auto outline = makeOutline({{0, 0}, {1, 0}, {1, 0}, {0.5, 1}, {0, 0}});
  ASSERT_TRUE(outline.ok());
  EXPECT_EQ(outline->corners.size(), 3U);
}

TEST(Outline, RefusesWhatIsNoPolygon) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(makeOutline({{0, 0}, {1, 0}}).error().what,
            "expected a polygon of at least 3 different corners");
  EXPECT_EQ(makeOutline({{0, 0}, {1, 0}, {2, 0}}).error().what, "the polygon has no area");
  EXPECT_EQ(makeOutline({{0, 0}, {2, 2}, {2, 0}, {0, 1}}).error().what,
            "edges of the polygon cross each other");
  EXPECT_EQ(makeOutline({{0, 0}, {nan, 0}, {0, 1}}).error().what,
            "a corner of the polygon is not a finite number");
  // A figure of eight through a common corner: no edges cross inside, but one loop runs backwards.
  EXPECT_EQ(makeOutline({{0, 0}, {1, 1}, {3, 3}, {3, -1}, {1, 1}, {0, 2}}).error().what,
            "the polygon runs over itself");
}

}  // namespace
}  // namespace soffit::light
