// SPDX-License-Identifier: MIT
#include "core/photometry/planes.h"

#include <gmock/gmock.h>

#include <limits>

namespace soffit::photometry {
namespace {

using ::testing::ElementsAre;

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Planes whose candela are the given values at every gamma.
StoredPlanes planes(std::vector<double> c_deg, const std::vector<double>& values) {
  StoredPlanes s{std::move(c_deg), {0.0, 180.0}, {}};
  for (const double v : values) s.candela.insert(s.candela.end(), {v, v});
  return s;
}

std::vector<double> values(const IntensityDistribution& d) {
  std::vector<double> v;
  for (std::size_t i = 0; i < d.candela.size(); i += 2) v.push_back(d.candela[i]);
  return v;
}

TEST(Planes, OnePlaneIsAxial) {
  const auto d = unfold(planes({45.0}, {7}), Mirror::none);
  EXPECT_THAT(d.c_deg, ElementsAre(0.0));
  EXPECT_NEAR(d.flux(), 28.0 * kPi, 1000 * kEps);
}

TEST(Planes, QuadrantsAreMirroredTwice) {
  const auto d = unfold(planes({0, 30, 90}, {1, 2, 3}), Mirror::both);
  EXPECT_THAT(d.c_deg, ElementsAre(0, 30, 90, 150, 180, 210, 270, 330));
  EXPECT_THAT(values(d), ElementsAre(1, 2, 3, 2, 1, 2, 3, 2));
}

TEST(Planes, HalvesAreMirroredAboutTheirOwnEnds) {
  const auto c0 = unfold(planes({0, 90, 180}, {1, 2, 3}), Mirror::c0);
  EXPECT_THAT(c0.c_deg, ElementsAre(0, 90, 180, 270));
  EXPECT_THAT(values(c0), ElementsAre(1, 2, 3, 2));
  const auto c90 = unfold(planes({90, 180, 270}, {1, 2, 3}), Mirror::c90);
  EXPECT_THAT(c90.c_deg, ElementsAre(0, 90, 180, 270));
  EXPECT_THAT(values(c90), ElementsAre(2, 1, 2, 3));
  const auto wrapped = unfold(planes({270, 300, 360, 450}, {1, 2, 3, 4}), Mirror::c90);
  EXPECT_THAT(wrapped.c_deg, ElementsAre(0, 90, 180, 240, 270, 300));
  EXPECT_THAT(values(wrapped), ElementsAre(3, 4, 3, 2, 1, 2));
}

TEST(Planes, TheClosingPlaneIsFoldedInWithoutChangingTheLumens) {
  // Trapezoid over 0, 90, 270, 360 with 4, 1, 1, 8 at the knots:
  // 90·2.5 + 180·1 + 90·4.5 = 810 degrees·cd, times 2 per radian of C.
  const auto d = unfold(planes({0, 90, 270, 360}, {4, 1, 1, 8}), Mirror::none);
  EXPECT_THAT(d.c_deg, ElementsAre(0, 90, 270));
  EXPECT_NEAR(d.flux(), 2.0 * radians(810.0), 1000 * kEps);
  const auto uneven = unfold(planes({0, 90, 350, 360}, {4, 1, 1, 8}), Mirror::none);
  EXPECT_NEAR(uneven.flux(), 2.0 * radians(90 * 2.5 + 260 + 10 * 4.5), 1000 * kEps);
}

TEST(Planes, ACircleWithoutC0GetsOneWithoutChangingTheLumens) {
  const auto d = unfold(planes({45, 135, 225, 315}, {1, 2, 3, 5}), Mirror::none);
  EXPECT_THAT(d.c_deg, ElementsAre(0, 45, 135, 225, 315));
  EXPECT_THAT(values(d), ElementsAre(3, 1, 2, 3, 5));
  EXPECT_NEAR(d.flux(), 4.0 * kPi * 11.0 / 4.0, 1000 * kEps);
}

TEST(Planes, FoldingKeepsTheFewestPlanesThatUnfoldAgain) {
  const auto mirrorOf = [](const StoredPlanes& stored, Mirror mirror) {
    const auto whole = unfold(stored, mirror);
    const auto [part, found] = fold(whole);
    EXPECT_EQ(part.c_deg.size(), stored.c_deg.size());
    EXPECT_EQ(unfold(part, found).candela, whole.candela);
    return found;
  };
  EXPECT_EQ(mirrorOf(planes({0, 30, 90}, {1, 2, 3}), Mirror::both), Mirror::both);
  EXPECT_EQ(mirrorOf(planes({0, 30, 180}, {1, 2, 3}), Mirror::c0), Mirror::c0);
  EXPECT_EQ(mirrorOf(planes({90, 100, 270}, {1, 2, 3}), Mirror::c90), Mirror::c90);
  EXPECT_EQ(mirrorOf(planes({0, 30, 270}, {1, 2, 3}), Mirror::none), Mirror::none);
  EXPECT_EQ(mirrorOf(planes({0}, {1}), Mirror::none), Mirror::none);
}

}  // namespace
}  // namespace soffit::photometry
