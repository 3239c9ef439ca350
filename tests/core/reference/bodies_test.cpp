// SPDX-License-Identifier: MIT
#include "rooms.h"

#include <gtest/gtest.h>

/// Luminaires whose bodies block light.
namespace soffit::reference {
namespace {

using test::luminaire;

const scene::Sensor kSensor{dvec3(0), dvec3(0, 0, 1)};
constexpr double kBare = 1000.0 / kPi / 16.0;  // a Lambertian point 4 m above

/// Illuminance from a point 4 m above the sensor with another luminaire in between.
double withBody(light::Luminaire body, bool casts_shadow) {
  body.casts_shadow = casts_shadow;
  body.on = false;
  const ReferenceScene scene = test::prepare(
      test::Builder().scene(), {luminaire(light::PointShape{}, {0, 0, 4}), std::move(body)});
  EstimateOptions options;
  options.min_replicates = 2;
  return test::measure(scene, kSensor, options).total;
}

light::Luminaire turned(light::Luminaire l, const dvec3& rotation_deg) {
  l.rotation_deg = rotation_deg;
  return l;
}

TEST(Bodies, BlockLightOnlyIfTheyCastShadows) {
  const auto mesh =
      test::Builder().box({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}, test::matte(0)).scene().mesh;
  const dvec3 between(0.01, 0.02, 1.0);
  const light::Luminaire bodies[] = {
      luminaire(light::Rectangle{0.4, 0.2}, between),
      turned(luminaire(light::Rectangle{0.4, 0.2}, between), {180, 0, 0}),  // its black back
      luminaire(light::Disk{0.1}, between),
      luminaire(light::Polygon{{{-1, -1}, {1, -1}, {0, 1}}}, between),
      luminaire(light::Sphere{0.1}, between),
      luminaire(light::Tube{1.0, 0.05}, between),
      turned(luminaire(light::Tube{1.0, 0.05}, between), {0, 90, 0}),  // through its closed ends
      luminaire(light::MeshShape{"m.obj", 1.0, 'z', mesh}, between)};
  for (const light::Luminaire& body : bodies) {
    EXPECT_EQ(withBody(body, true), 0.0);
    EXPECT_NEAR(withBody(body, false), kBare, 1e-9 * kBare);  // round-off
  }
}

TEST(Bodies, BesideTheRayBlockNothing) {
  EXPECT_NEAR(withBody(luminaire(light::Rectangle{0.4, 0.2}, {0.3, 0, 1}), true), kBare,
              1e-9 * kBare);
  EXPECT_NEAR(withBody(luminaire(light::Sphere{0.1}, {0, 0, 4.2}), true), kBare, 1e-9 * kBare);
}

double alone(light::Luminaire l, bool casts_shadow, const dvec3& position = dvec3(0)) {
  l.casts_shadow = casts_shadow;
  EstimateOptions options;
  options.paths_per_replicate = 256;
  return test::measure(test::prepare(test::Builder().scene(), {l}), {position, {0, 0, 1}}, options)
      .total;
}

TEST(Bodies, DoNotHideTheirOwnLight) {
  for (const light::Shape& shape :
       {light::Shape(light::Rectangle{0.4, 0.2}), light::Shape(light::Disk{0.2}),
        light::Shape(light::Sphere{0.2}), light::Shape(light::Tube{1, 0.1})}) {
    const light::Luminaire l = luminaire(shape, {0, 0, 0.5});
    EXPECT_EQ(alone(l, true), alone(l, false));  // the same paths
  }
}

TEST(Bodies, OfMeshesShadeThemselves) {
  // Two equal sheets that look down, the upper one in the lower one's shadow.
  const auto mesh = test::Builder()
                        .quad({-0.5, -0.5, 0}, {0, 1, 0}, {1, 0, 0}, test::matte(0))
                        .quad({-0.5, -0.5, 0.1}, {0, 1, 0}, {1, 0, 0}, test::matte(0))
                        .scene()
                        .mesh;
  const auto lower =
      test::Builder().quad({-0.5, -0.5, 0}, {0, 1, 0}, {1, 0, 0}, test::matte(0)).scene().mesh;
  const light::Luminaire both = luminaire(light::MeshShape{"b.obj", 1.0, 'z', mesh}, {0, 0, 0.3});
  const light::Luminaire one =
      luminaire(light::MeshShape{"o.obj", 1.0, 'z', lower}, {0, 0, 0.3}, 500.0);
  // Straight below the sheets' middle the lower one covers the upper one.
  const double front = alone(one, false);
  EXPECT_NEAR(alone(both, true), front, 0.01 * front);  // statistical, 16 x 256 paths: below 0.3 %
  EXPECT_GT(alone(both, false), 1.5 * front);
}

TEST(Bodies, ShadeTheCeilingAboveAPanel) {
  // A panel under a white ceiling and above a white floor; a sensor on the ceiling above it.
  const auto room = test::Builder()
                        .quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, test::matte(0.8))
                        .quad({-5, -5, 3}, {10, 0, 0}, {0, 10, 0}, test::matte(0.8))
                        .scene();
  light::Luminaire panel = luminaire(light::Rectangle{1, 1}, {0, 0, 2.999});
  EstimateOptions options;
  options.paths_per_replicate = 256;
  const scene::Sensor above{{0, 0, 3}, {0, 0, -1}};
  EXPECT_GT(test::measure(test::prepare(room, {panel}), above, options).total, 10.0);
  panel.casts_shadow = true;
  // Black seen from above; what is left comes through the 1 mm gap from half a metre aside.
  EXPECT_LT(test::measure(test::prepare(room, {panel}), above, options).total, 0.1);
}

}  // namespace
}  // namespace soffit::reference
