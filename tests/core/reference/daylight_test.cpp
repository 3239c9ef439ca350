// SPDX-License-Identifier: MIT
#include "core/daylight/slab.h"
#include "rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Sky, sun and glass in the path tracer against closed forms.
namespace soffit::reference {
namespace {

using test::kSigmas;
using test::matte;

constexpr double kPiLux = 1000.0;  // lx of the even sky: 1000 / pi cd/m^2

scene::Environment evenSky(double ground = 0.0) {
  return {"", scene::Sky{.cie = 5, .horizontal_illuminance = kPiLux, .ground_reflectance = ground}};
}

scene::Material glass(double transmittance = 0.88) {
  scene::Material m;
  m.glass = scene::Glass{1.52, transmittance};
  return m;
}

SensorEstimate read(scene::Scene scene, const scene::Sensor& sensor, double error = 0.004) {
  const ReferenceScene ready = ReferenceScene::make(scene, {}).value();
  EstimateOptions options;
  options.relative_error = error;
  return test::measure(ready, sensor, options);
}

void expectNear(double found, double error, double wanted) {
  // Statistical; the last term is round-off where nothing varies.
  EXPECT_NEAR(found, wanted, kSigmas * error + 2e-6 * wanted);
}

TEST(ReferenceDaylight, AnOpenPlaneGetsPiL) {
  scene::Scene scene = test::Builder().scene();
  scene.environment = evenSky(0.3);
  const SensorEstimate up = read(scene, {{0, 0, 0}, {0, 0, 1}});
  expectNear(up.direct, up.standard_error, kPiLux);
  EXPECT_EQ(up.indirect, 0.0);
  const SensorEstimate down = read(scene, {{0, 0, 0}, {0, 0, -1}});
  expectNear(down.direct, down.standard_error, 0.3 * kPiLux);
  const SensorEstimate side = read(scene, {{0, 0, 0}, {1, 0, 0}});
  expectNear(side.direct, side.standard_error, 0.5 * 1.3 * kPiLux);
}

TEST(ReferenceDaylight, EveryStandardSkyGivesItsHorizontalIlluminance) {
  for (int type = 1; type <= 16; ++type) {
    scene::Scene scene = test::Builder().scene();
    scene.environment = scene::Environment{
        "", scene::Sky{.cie = type, .sun_altitude_deg = 25.0, .horizontal_illuminance = 9000.0}};
    const SensorEstimate e = read(scene, {{0, 0, 0}, {0, 0, 1}});
    expectNear(e.direct, e.standard_error, 9000.0);
  }
}

TEST(ReferenceDaylight, TheSunFollowsTheCosine) {
  scene::Scene scene = test::Builder().scene();
  scene.environment = scene::Environment{
      "", scene::Sky{.cie = 12, .sun_altitude_deg = 30.0, .direct_normal_illuminance = 50000.0}};
  const SensorEstimate e = read(scene, {{0, 0, 0}, {0, 0, 1}});
  // 1e-5 of the light is left to rays that meet the disc by chance, one in 1e5.
  const double wanted = 50000.0 * std::sin(radians(30.0));
  EXPECT_NEAR(e.direct, wanted, kSigmas * e.standard_error + 2e-5 * wanted);
}

/// A wall around a hole of 1.2 x 1.2 m at x = 0, in a box 40 m deep.
test::Builder windowHall(double reflectance) {
  const scene::Material wall = matte(reflectance);
  test::Builder b;
  const dvec3 y(0, 1, 0);
  const dvec3 z(0, 0, 1);
  const dvec3 x(40, 0, 0);
  b.quad({0, -20, -20}, 40.0 * y, 20.9 * z, wall).quad({0, -20, 2.1}, 40.0 * y, 17.9 * z, wall);
  b.quad({0, -20, 0.9}, 19.4 * y, 1.2 * z, wall).quad({0, 0.6, 0.9}, 19.4 * y, 1.2 * z, wall);
  b.quad({40, -20, -20}, 40.0 * y, 40.0 * z, wall);
  for (const double at : {-20.0, 20.0}) {
    b.quad({0, at, -20}, x, 40.0 * z, wall).quad({0, -20, at}, x, 40.0 * y, wall);
  }
  return b;
}

/// The sum over the hole of T(angle) cos cos' / r^2 dA.
double throughWindow(const dvec3& p, const dvec3& n, const daylight::Slab* slab) {
  constexpr int kSteps = 300;
  double sum = 0.0;
  for (int j = 0; j < kSteps; ++j) {
    for (int i = 0; i < kSteps; ++i) {
      const dvec3 to =
          dvec3(0, -0.6 + 1.2 * (i + 0.5) / kSteps, 0.9 + 1.2 * (j + 0.5) / kSteps) - p;
      const double r = glm::length(to);
      sum += (slab != nullptr ? slab->at(to.x / r).transmitted : 1.0) *
             std::max(0.0, glm::dot(to, n)) * std::abs(to.x) / (r * r * r * r);
    }
  }
  return sum * 1.44 / (kSteps * kSteps);
}

TEST(ReferenceDaylight, AWindowFollowsItsProjectedSolidAngle) {
  scene::Scene scene = windowHall(0.0).scene();
  scene.environment = evenSky(1.0);
  for (const scene::Sensor& s :
       {scene::Sensor{{1.5, 0.3, 0.8}, {0, 0, 1}}, scene::Sensor{{3, -0.5, 1.2}, {-1, 0, 0}}}) {
    const SensorEstimate e = read(scene, s);
    expectNear(e.direct, e.standard_error,
               kPiLux / kPi * throughWindow(s.position, s.normal, nullptr));
    EXPECT_EQ(e.indirect, 0.0);
  }
}

TEST(ReferenceDaylight, GlassDimsByItsAngle) {
  const daylight::Slab slab({1.52, 0.88});
  scene::Scene scene =
      windowHall(0.0).quad({0, -0.6, 0.9}, {0, 1.2, 0}, {0, 0, 1.2}, glass()).scene();
  scene.environment = evenSky(1.0);
  for (const scene::Sensor& s :
       {scene::Sensor{{1.5, 0.3, 0.8}, {0, 0, 1}}, scene::Sensor{{3, -0.5, 1.2}, {-1, 0, 0}}}) {
    const SensorEstimate e = read(scene, s);
    expectNear(e.direct, e.standard_error,
               kPiLux / kPi * throughWindow(s.position, s.normal, &slab));
  }
}

TEST(ReferenceDaylight, TheSunShinesThroughGlass) {
  const daylight::Slab slab({1.52, 0.88});
  scene::Scene scene = test::Builder().quad({-5, -5, 2}, {10, 0, 0}, {0, 10, 0}, glass()).scene();
  scene.environment = scene::Environment{
      "", scene::Sky{.cie = 12, .sun_altitude_deg = 50.0, .direct_normal_illuminance = 50000.0}};
  const SensorEstimate e = read(scene, {{0, 0, 1}, {0, 0, 1}});
  const double sine = std::sin(radians(50.0));
  // The disc's 0.5 degrees: T is flat enough for its middle.
  EXPECT_NEAR(e.direct, 50000.0 * sine * slab.at(sine).transmitted,
              kSigmas * e.standard_error + 5e-5 * e.direct);
}

TEST(ReferenceDaylight, LuminairesShineThroughGlassAndAreMirroredInIt) {
  // A small lamp over a pane, the sensor below: T of direct light. One beside it sees its mirror
  // image with R, twice as far away.
  const daylight::Slab slab({1.52, 0.88});
  const scene::Scene scene =
      test::Builder().quad({-50, -50, 1}, {100, 0, 0}, {0, 100, 0}, glass()).scene();
  const light::Luminaire lamp = test::luminaire(light::Sphere{0.05}, {0, 0, 2});
  const ReferenceScene ready = test::prepare(scene, {lamp});
  EstimateOptions options;
  options.relative_error = 0.004;
  const SensorEstimate below = test::measure(ready, {{0, 0, 0}, {0, 0, 1}}, options);
  const double candela = 1000.0 / (4.0 * kPi);
  EXPECT_NEAR(below.direct, 0.88 * candela / 4.0,
              kSigmas * below.standard_error + 3e-4 * below.direct);
}

TEST(ReferenceDaylight, GlassMirrorsLuminaires) {
  // A panel of 1 x 1 m, 1 m over a pane, shines down; a sensor between them that looks down sees
  // its image 1 m below the pane alone.
  const scene::Scene scene =
      test::Builder().quad({-50, -50, 1}, {100, 0, 0}, {0, 100, 0}, glass()).scene();
  const ReferenceScene ready =
      test::prepare(scene, {test::luminaire(light::Rectangle{1.0, 1.0}, {0, 0, 2})});
  const daylight::Slab slab({1.52, 0.88});
  double wanted = 0.0;
  constexpr int kSteps = 200;
  for (int k = 0; k < kSteps * kSteps; ++k) {
    const dvec3 to((k % kSteps + 0.5) / kSteps - 0.5, (k / kSteps + 0.5) / kSteps - 0.5, -1.5);
    const double r = glm::length(to);
    wanted += slab.at(1.5 / r).reflected * 2.25 / (r * r * r * r) / (kSteps * kSteps);
  }
  wanted *= 1000.0 / kPi;
  EstimateOptions options;
  options.relative_error = 0.02;
  const SensorEstimate e = test::measure(ready, {{0, 0, 1.5}, {0, 0, -1}}, options);
  EXPECT_EQ(e.direct, 0.0);
  EXPECT_NEAR(e.indirect, wanted, kSigmas * e.standard_error);
}

TEST(ReferenceDaylight, AWhiteClosedHallWithALosslessPaneLosesNothingInside) {
  // Between two halls of equal even light a lossless pane changes nothing: what it keeps back it
  // mirrors. Here: a floor under an even sphere of light, half of it seen through a pane.
  scene::Scene scene =
      test::Builder().quad({-1, -1, 0.5}, {2, 0, 0}, {0, 2, 0}, glass(1.0)).scene();
  scene.environment = evenSky(1.0);
  const SensorEstimate e = read(scene, {{0, 0, 0}, {0, 0, 1}}, 0.002);
  EXPECT_GT(e.indirect, 0.0) << "the mirror";
  expectNear(e.total, e.standard_error, kPiLux);
}

TEST(ReferenceDaylight, AnEvenEnclosureOfAnyReflectanceStaysEven) {
  // A grey block under light of L from everywhere: what hides the sky reflects rho L E/(pi L): with
  // rho = 1 every sensor sees L everywhere.
  scene::Scene scene = test::Builder().box({0.5, -1, -1}, {1.5, 1, 1}, matte(1.0)).scene();
  scene.environment = evenSky(1.0);
  const SensorEstimate e = read(scene, {{0, 0, 0}, {1, 0, 0}}, 0.003);
  expectNear(e.total, e.standard_error, kPiLux);
  EXPECT_GT(e.indirect, 0.3 * kPiLux);
}

TEST(ReferenceDaylight, APictureGivesItsSkysLight) {
  // A probe painted with the traditional overcast sky.
  auto image = std::make_shared<scene::Image>();
  image->width = 256;
  image->height = 128;
  const daylight::CieSky sky(16, {0, 0, 1}, 5000.0);
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      const double h = 0.5 * kPi - kPi * (y + 0.5) / image->height;
      const double l = h >= 0.0 ? sky.luminance({std::cos(h), 0.0, std::sin(h)}) : 0.0;
      image->pixels.insert(image->pixels.end(), 3, static_cast<float>(l));
    }
  }
  scene::Scene scene = test::Builder().scene();
  scene.environment =
      scene::Environment{"", scene::Probe{"p", scene::ProbeLayout::lat_long, 20.0, 1.0, image}};
  const SensorEstimate e = read(scene, {{0, 0, 0}, {0, 0, 1}});
  // Truncation: half a row of pixels at the horizon, 0.7 degrees of it weighted by its sine.
  EXPECT_NEAR(e.direct, 5000.0, kSigmas * e.standard_error + 1e-3 * 5000.0);
}

TEST(ReferenceDaylight, BodiesOfLuminairesHideTheSky) {
  light::Luminaire board = test::luminaire(light::Rectangle{200.0, 200.0}, {0, 0, 1}, 0.0);
  board.casts_shadow = true;
  scene::Scene scene = test::Builder().scene();
  scene.environment = evenSky();
  const ReferenceScene ready = ReferenceScene::make(scene, std::vector{board}).value();
  EstimateOptions options;
  options.relative_error = 0.05;
  EXPECT_LT(test::measure(ready, {{0, 0, 0}, {0, 0, 1}}, options).total, 0.01 * kPiLux);
}

TEST(ReferenceDaylight, NothingShinesInWhereItIsLeftOut) {
  scene::Scene scene = test::Builder().scene();
  scene.environment = evenSky();
  const ReferenceScene ready = ReferenceScene::make(scene, {}, nullptr, false).value();
  EXPECT_EQ(ready.environment(), nullptr);
  EXPECT_EQ(test::measure(ready, {{0, 0, 0}, {0, 0, 1}}, {}).total, 0.0);
}

}  // namespace
}  // namespace soffit::reference
