// SPDX-License-Identifier: MIT
#include "core/photometry/beam.h"

#include "tests/core/photometry/distributions.h"

#include <gtest/gtest.h>

namespace soffit::photometry {
namespace {

constexpr double kRoundoff = 1e-11;  // degrees: some tens of operations on angles up to 360

IntensityDistribution axial(std::vector<double> gamma, std::vector<double> candela) {
  IntensityDistribution d;
  d.c_deg = {0.0};
  d.gamma_deg = std::move(gamma);
  d.candela = std::move(candela);
  return d;
}

TEST(Beam, ATriangleOpensToItsHalfAndItsTenth) {
  // 100 cd falling linearly to 0 at 40 degrees: half at ±20, a tenth at ±36.
  const auto d = axial({0, 40, 90}, {100, 0, 0});
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 40.0, kRoundoff);
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c90_deg, 40.0, kRoundoff);
  EXPECT_NEAR(fieldAngles(d, BeamReference::centre).c0_deg, 72.0, kRoundoff);
}

TEST(Beam, LambertianIsAHundredAndTwentyDegrees) {
  const auto d = tabulate([](double, double g) { return std::cos(g); }, 1, 91, 0, 90);
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 120.0, kRoundoff);  // 60 is a knot
}

TEST(Beam, BatwingPeakAndCentreDiffer) {
  // Dip on the axis: 40 cd, 100 cd at 30, 0 at 80.
  const auto d = axial({0, 30, 80, 90}, {40, 100, 0, 0});
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 2 * 55.0, kRoundoff);    // 50 cd
  EXPECT_NEAR(beamAngles(d, BeamReference::centre).c0_deg, 2 * 70.0, kRoundoff);  // 20 cd
}

TEST(Beam, PlanesAreJudgedAlone) {
  IntensityDistribution d;
  d.c_deg = {0, 90, 180, 270};
  d.gamma_deg = {0, 20, 60, 90};
  d.candela = {100, 0, 0, 0, 100, 100, 0, 0, 100, 0, 0, 0, 100, 100, 0, 0};
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 20.0, kRoundoff);
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c90_deg, 80.0, kRoundoff);
}

TEST(Beam, OneSidedLightHasItsOwnLobesWidth) {
  IntensityDistribution d;  // only at C0, a triangle around 45 from 25 to 65
  d.c_deg = {0, 90, 180, 270};
  d.gamma_deg = {0, 25, 45, 65, 90};
  d.candela.assign(20, 0.0);
  d.candela[2] = 100.0;
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 20.0, kRoundoff);
  EXPECT_EQ(beamAngles(d, BeamReference::peak).c90_deg, 0.0);
  EXPECT_EQ(beamAngles(d, BeamReference::centre).c0_deg, 0.0);
}

TEST(Beam, UplightsOpenAboutTheZenith) {
  const auto d = axial({90, 150, 180}, {0, 0, 100});
  EXPECT_NEAR(beamAngles(d, BeamReference::peak).c0_deg, 30.0, kRoundoff);
}

TEST(Beam, GlobesAreWholeAndHemispheresHalf) {
  EXPECT_NEAR(beamAngles(axial({0, 180}, {5, 5}), BeamReference::peak).c0_deg, 360.0, kRoundoff);
  EXPECT_NEAR(beamAngles(axial({0, 90}, {5, 5}), BeamReference::peak).c0_deg, 180.0, kRoundoff);
}

TEST(Beam, LightPastTheHorizonIsFollowedButASecondLobeIsNot) {
  const auto wide = axial({0, 100, 140, 180}, {100, 100, 0, 0});
  EXPECT_NEAR(beamAngles(wide, BeamReference::peak).c0_deg, 240.0, kRoundoff);
  const auto two_lobes = axial({0, 60, 120, 180}, {100, 0, 0, 60});
  EXPECT_NEAR(beamAngles(two_lobes, BeamReference::peak).c0_deg, 60.0, kRoundoff);
}

TEST(Beam, DarknessHasNoAngle) {
  EXPECT_EQ(beamAngles(axial({0, 90}, {0, 0}), BeamReference::peak).c0_deg, 0.0);
  EXPECT_EQ(beamAngleDeg({}, 0.0, 0.5, BeamReference::peak), 0.0);
}

}  // namespace
}  // namespace soffit::photometry
