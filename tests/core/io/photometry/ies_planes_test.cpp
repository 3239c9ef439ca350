// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_planes.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::io {
namespace {

const std::vector<double> kDown{0, 45, 90};

/// Plane i has i + 1 cd at every vertical angle.
IesTable table(IesType type, std::vector<double> horizontal, std::vector<double> vertical = kDown) {
  IesTable t{type, std::move(vertical), std::move(horizontal), {}};
  for (std::size_t i = 0; i < t.horizontal_deg.size(); ++i) {
    t.candela.insert(t.candela.end(), t.vertical_deg.size(), static_cast<double>(i + 1));
  }
  return t;
}

IesSphere sphereOf(const IesTable& t) {
  EXPECT_TRUE(checkIesAngles(t.type, t.vertical_deg, t.horizontal_deg).ok());
  return toSphere(t);
}

double at(const IesSphere& s, double c) {
  return s.distribution.intensityAt(c, 45.0);
}

TEST(IesPlanes, AllHorizontalSetsOfTypeC) {
  const IesSphere axial = sphereOf(table(IesType::c, {0}));
  EXPECT_EQ(axial.symmetry, "axial");
  EXPECT_EQ(at(axial, 123), 1.0);

  const IesSphere quadrant = sphereOf(table(IesType::c, {0, 45, 90}));
  EXPECT_EQ(quadrant.symmetry, "quadrant 0-90");
  for (const double c : {45.0, 135.0, 225.0, 315.0}) EXPECT_EQ(at(quadrant, c), 2.0);
  EXPECT_EQ(at(quadrant, 270), 3.0);

  const IesSphere half = sphereOf(table(IesType::c, {0, 90, 180}));
  EXPECT_EQ(half.symmetry, "bilateral 0-180");
  EXPECT_EQ(at(half, 90), 2.0);
  EXPECT_EQ(at(half, 270), 2.0);
  EXPECT_EQ(at(half, 180), 3.0);

  const IesSphere side = sphereOf(table(IesType::c, {90, 180, 270}));
  EXPECT_EQ(side.symmetry, "bilateral 90-270");
  EXPECT_EQ(at(side, 90), 1.0);
  EXPECT_EQ(at(side, 0), 2.0);
  EXPECT_EQ(at(side, 180), 2.0);
  EXPECT_EQ(at(side, 270), 3.0);

  const IesSphere all = sphereOf(table(IesType::c, {0, 90, 180, 270, 360}));
  EXPECT_EQ(all.symmetry, "none 0-360");
  EXPECT_EQ(at(all, 270), 4.0);

  const IesSphere unclosed = sphereOf(table(IesType::c, {0, 90, 180, 270}));
  EXPECT_EQ(unclosed.symmetry, "none 0-270");
  EXPECT_EQ(at(unclosed, 315), 2.5);
}

TEST(IesPlanes, OddCirclesAreUnderstoodToo) {
  const IesSphere signed_half = sphereOf(table(IesType::c, {-90, 0, 90}));
  EXPECT_EQ(at(signed_half, 270), 1.0);
  EXPECT_EQ(at(signed_half, 180), 2.0);
  EXPECT_EQ(at(signed_half, 90), 3.0);
  const IesSphere signed_whole = sphereOf(table(IesType::c, {-180, -90, 0, 90, 180}));
  EXPECT_EQ(at(signed_whole, 270), 2.0);
  EXPECT_EQ(at(signed_whole, 90), 4.0);
  const IesSphere lone = sphereOf(table(IesType::c, {90}));
  EXPECT_EQ(lone.warnings.at(0), "the only plane is C90; it is taken for all");
}

TEST(IesPlanes, VerticalRangesAreNotExtrapolated) {
  constexpr double kRoundoff = 1000 * std::numeric_limits<double>::epsilon();
  const IesSphere down = sphereOf(table(IesType::c, {0}, {0, 90}));
  EXPECT_NEAR(down.lumens, 2 * kPi, kRoundoff);
  EXPECT_EQ(down.distribution.intensityAt(0, 91), 0.0);
  const IesSphere up = sphereOf(table(IesType::c, {0}, {90, 180}));
  EXPECT_NEAR(up.lumens, 2 * kPi, kRoundoff);
  EXPECT_EQ(up.distribution.intensityAt(0, 89), 0.0);
  const IesSphere all = sphereOf(table(IesType::c, {0}, {0, 180}));
  EXPECT_NEAR(all.lumens, 4 * kPi, kRoundoff);
  const IesSphere cut = sphereOf(table(IesType::c, {0}, {0, 60}));
  EXPECT_NEAR(cut.lumens, kPi, kRoundoff);
  EXPECT_EQ(cut.warnings.at(0), "the vertical angles cover 0..60 only; beyond them it is dark");
}

TEST(IesPlanes, TypesAAndBKeepTheirLumensAndFacePlusGammaZero) {
  constexpr double kRoundoff = 1e5 * std::numeric_limits<double>::epsilon();
  const std::vector<double> whole{-90, -30, 0, 30, 90};
  const IesSphere b = sphereOf({IesType::b, whole, {0, 45, 90}, std::vector<double>(15, 2.0)});
  EXPECT_EQ(b.symmetry, "type B 0-90 (H mirrored)");
  EXPECT_NEAR(b.lumens, 4 * kPi, kRoundoff);
  EXPECT_NEAR(b.distribution.flux(), 4 * kPi, kRoundoff);
  EXPECT_EQ(b.distribution.intensityAt(0, 100), 0.0);
  const IesSphere a = sphereOf({IesType::a, whole, whole, std::vector<double>(25, 2.0)});
  EXPECT_EQ(a.symmetry, "type A -90-90 (none)");
  EXPECT_NEAR(a.distribution.flux(), 4 * kPi, kRoundoff);
  const IesSphere half = sphereOf({IesType::b, {0, 90}, {0, 90}, std::vector<double>(4, 2.0)});
  EXPECT_EQ(half.warnings.at(0), "the vertical angles start at 0; below that it is dark");
}

std::string refusal(IesType type, std::vector<double> v, std::vector<double> h) {
  const auto r = checkIesAngles(type, v, h);
  return r ? "accepted" : r.error().message();
}

TEST(IesPlanes, OtherAnglesAreRefused) {
  EXPECT_EQ(refusal(IesType::c, kDown, {0, 20, 45}),
            "expected horizontal angles 0, 0..90, 0..180, 90..270 or 0..360, found 0..45. The "
            "angles are damaged, or planes are missing.");
  EXPECT_EQ(refusal(IesType::c, {0, 200}, {0}),
            "expected vertical angles within 0..180, found 0..200. The angles are damaged, or the "
            "photometric type is another one.");
  EXPECT_EQ(refusal(IesType::c, {-90, 90}, {0}).substr(0, 40),
            "expected vertical angles within 0..180, ");
  EXPECT_EQ(refusal(IesType::c, kDown, {0, 720}).substr(0, 43),
            "expected horizontal angles within -180..360");
  EXPECT_EQ(refusal(IesType::b, kDown, {0}),
            "expected at least 2 horizontal angles for photometry of type A or B, found 1. Only "
            "type C can do with one.");
  EXPECT_EQ(refusal(IesType::b, kDown, {0, 120}).substr(0, 41),
            "expected horizontal angles within -90..90");
  EXPECT_EQ(refusal(IesType::a, {-120, 0}, {0, 90}).substr(0, 39),
            "expected vertical angles within -90..90");
}

}  // namespace
}  // namespace soffit::io
