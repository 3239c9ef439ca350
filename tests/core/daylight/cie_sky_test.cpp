// SPDX-License-Identifier: MIT
#include "core/daylight/cie_sky.h"

#include "core/math/quadrature.h"
#include "core/math/rng.h"

#include <gtest/gtest.h>

namespace soffit::daylight {
namespace {

/// Horizontal illuminance by a rule of its own: Gauss in the zenith angle, and about the sun's
/// azimuth where the cusp lies.
double horizontal(const CieSky& sky, double sun_azimuth) {
  const QuadratureRule zenith = gaussLegendre(300, 0.0, 0.5 * kPi);
  const QuadratureRule azimuth = gaussLegendre(200, 0.0, kPi);
  double sum = 0.0;
  for (std::size_t i = 0; i < zenith.nodes.size(); ++i) {
    const double z = zenith.nodes[i];
    for (std::size_t j = 0; j < azimuth.nodes.size(); ++j) {
      for (const double side : {-1.0, 1.0}) {
        const dvec3 d = skyDirection(sun_azimuth + side * azimuth.nodes[j], 0.5 * kPi - z);
        sum +=
            zenith.weights[i] * azimuth.weights[j] * std::sin(z) * std::cos(z) * sky.luminance(d);
      }
    }
  }
  return sum;
}

TEST(CieSky, EveryTypeGivesItsHorizontalIlluminance) {
  for (int type = 1; type <= 16; ++type) {
    for (const double altitude : {5.0, 30.0, 60.0, 90.0}) {
      const double azimuth = radians(137.0);
      const CieSky sky(type, skyDirection(azimuth, radians(altitude)), 10000.0);
      // Truncation: the cusp at the sun, second order in the rules' steps of half a degree.
      EXPECT_NEAR(horizontal(sky, azimuth), 10000.0, 10000.0 * 3e-5)
          << "type " << type << ", sun at " << altitude;
    }
  }
}

TEST(CieSky, AzimuthRunsClockwiseFromPlusY) {
  const auto expect = [](double azimuth, const dvec3& d) {
    EXPECT_LT(glm::length(skyDirection(radians(azimuth), 0.0) - d), 1e-15) << azimuth;
  };
  expect(0.0, {0, 1, 0});
  expect(90.0, {1, 0, 0});
  expect(180.0, {0, -1, 0});
  expect(270.0, {-1, 0, 0});
  EXPECT_LT(glm::length(skyDirection(1.0, 0.5 * kPi) - dvec3(0, 0, 1)), 1e-15);
}

TEST(CieSky, TheUniformSkyIsUniform) {
  const CieSky sky(5, skyDirection(1.0, 0.5), 1000.0);
  for (const double altitude : {0.0, 0.3, 1.0, 1.5}) {
    EXPECT_NEAR(sky.luminance(skyDirection(2.0, altitude)), 1000.0 / kPi, 1e-9 * 1000.0);
  }
}

TEST(CieSky, TheTraditionalOvercastSkyIsThriceAsBrightOverhead) {
  const CieSky sky(16, skyDirection(1.0, 0.5), 1000.0);
  // L_z = 9 E / (7 pi), Moon & Spencer.
  EXPECT_NEAR(sky.luminance({0, 0, 1}), 9000.0 / (7.0 * kPi), 1e-12 * 1000.0);
  EXPECT_NEAR(sky.luminance({0, 0, 1}) / sky.luminance({1, 0, 0}), 3.0, 1e-14);
}

TEST(CieSky, TheStandardOvercastSkyFollowsItsGradation) {
  // Type 1 has no indicatrix: L/Lz = (1 + 4 exp(-0.7/cos Z)) / (1 + 4 exp(-0.7)).
  const CieSky sky(1, skyDirection(1.0, 0.5), 1000.0);
  const double whole = 1.0 + 4.0 * std::exp(-0.7);
  EXPECT_NEAR(sky.relative(skyDirection(0.3, radians(30.0))), (1.0 + 4.0 * std::exp(-1.4)) / whole,
              1e-14);
  EXPECT_NEAR(sky.relative(skyDirection(0.3, 0.0)), 1.0 / whole, 1e-14);
}

TEST(CieSky, ClearSkiesAreBrightestAtTheSunAndDarkestAcrossTheZenith) {
  const dvec3 to_sun = skyDirection(0.0, radians(40.0));
  for (const int type : {12, 13, 14, 15}) {
    const CieSky sky(type, to_sun, 10000.0);
    Rng rng(7);
    for (int i = 0; i < 1000; ++i) {
      const dvec3 d = skyDirection(2.0 * kPi * rng.uniformDouble(),
                                   std::asin(0.02 + 0.98 * rng.uniformDouble()));
      EXPECT_GT(sky.luminance(d), 0.0);
      if (glm::dot(d, to_sun) < 0.5 && d.z > 0.5) {
        EXPECT_LT(sky.luminance(d), 0.5 * sky.luminance(to_sun));
      }
    }
  }
  // CIE S 011: the clear sky's zenith over the luminance at the sun's own place, from f and phi:
  // type 12, sun at 40 degrees: chi = 0 at the sun, 50 degrees at the zenith.
  const CieSky clear(12, to_sun, 10000.0);
  const auto f = [](double chi) {
    return 1.0 + 10.0 * (std::exp(-3.0 * chi) - std::exp(-1.5 * kPi)) +
           0.45 * std::cos(chi) * std::cos(chi);
  };
  const auto phi = [](double z) { return 1.0 - std::exp(-0.32 / std::cos(z)); };
  EXPECT_NEAR(clear.relative(to_sun), f(0.0) * phi(radians(50.0)) / (f(radians(50.0)) * phi(0.0)),
              1e-6);
}

TEST(CieSky, TablesAgreeWithTheFormula) {
  Rng rng(9);
  for (int type = 1; type <= 16; ++type) {
    const CieSky sky(type, skyDirection(2.0, radians(35.0)), 10000.0);
    for (int i = 0; i < 2000; ++i) {
      const double z = i == 0 ? 0.0 : rng.uniformDouble();
      const dvec3 d = skyDirection(2.0 * kPi * rng.uniformDouble(), std::asin(z));
      const double exact = sky.luminance(d);
      EXPECT_NEAR(sky.quickLuminance(d), exact, 1e-5 * exact) << type << ", z " << z;
    }
  }
}

}  // namespace
}  // namespace soffit::daylight
