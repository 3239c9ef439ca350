// SPDX-License-Identifier: MIT
// Luminaires where nobody would hang them: touching, inside and behind surfaces, without size and
// larger than the room.
#include "tests/core/relight/readings.h"

namespace soffit::relight {
namespace {

using namespace testing;

constexpr double kRho = 0.6;

const std::shared_ptr<const Solver>& emptyRoom() {
  static const auto solver = [] {
    auto mesh = emptyMesh();
    addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
    return solverFor(mesh, {dvec3(kRho)});
  }();
  return solver;
}

const std::shared_ptr<const Solver>& furnishedRoom() {
  static const auto solver = solverFor(blockRoom(), {dvec3(kRho)});
  return solver;
}

Lighting lit(const std::shared_ptr<const Solver>& solver, const light::Luminaire& luminaire) {
  Lighting lighting(solver);
  EXPECT_TRUE(lighting.setLuminaires(std::vector{luminaire}).ok());
  expectFinite(lighting);
  return lighting;
}

light::Luminaire with(const light::Shape& shape, const dvec3& position,
                      const dvec3& rotation_deg = dvec3(0.0)) {
  light::Luminaire l = panel(position);
  l.shape = shape;
  l.rotation_deg = rotation_deg;
  return l;
}

TEST(LightPlacement, TouchingTheCeilingIsLikeHangingAHairBelow) {
  const auto sensors = grid({0.2, 0.2, 0.8}, {3.6, 0, 0}, {0, 4.6, 0}, 6, 6);
  const Readings touching = readIn(emptyRoom(), {panel({2.1, 2.7, 3.0})}, sensors);
  const Readings below = readIn(emptyRoom(), {panel({2.1, 2.7, 2.999})}, sensors);
  // A millimetre of 2.2 m: E changes by 2/2200; the bounces alike.
  EXPECT_LT(relativeRms(touching.direct, below.direct), 2e-3);
  EXPECT_LT(relativeRms(touching.indirect, below.indirect), 2e-3);
  EXPECT_GT(mean(touching.direct), 10.0);
  // What lights the room is all of it.
  const Lighting lighting = lit(emptyRoom(), panel({2.1, 2.7, 3.0}));
  EXPECT_NEAR(totalFlux(lighting), 1000.0 / (1.0 - kRho), 1e-3 * 1000.0 / (1.0 - kRho));
}

TEST(LightPlacement, TouchingWallAndFloorLosesNothing) {
  // Upright in the plane of the wall x = 0, flush with the floor and the side wall.
  const auto error = [](int texels) {
    auto mesh = emptyMesh();
    addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
    auto settings = quickSettings();
    settings.texels = texels;
    settings.trainings = 8;  // for the direct light alone
    const auto solver = solverFor(mesh, {dvec3(kRho)}, settings);
    return std::abs(
        directFlux(lit(solver, with(light::Rectangle{0.6, 0.6}, {0.0, 0.3, 0.3}, {0, -90, 0}))) /
            1000.0 -
        1.0);
  };
  // Midpoint rule where E jumps at the light's edges: first order in the cell, so a quarter of the
  // texels' area halves it; 3 % at 15 cm on a light of 60 cm.
  const double coarse = error(4000);
  EXPECT_LT(coarse, 0.03);
  EXPECT_LT(error(16000), 0.6 * coarse);
}

TEST(LightPlacement, LyingOnTheFloorStaysWithinItsFlux) {
  // A millimetre above the floor and shining into it: the floor below gets it all, to the
  // resolution of 15 cm cells: each edge of 0.6 m may gain or lose half a cell, (1 + 0.15/0.6)^2.
  const Lighting above = lit(emptyRoom(), panel({2.03, 2.71, 0.001}));
  EXPECT_GT(directFlux(above), 1000.0 * 0.56);
  EXPECT_LT(directFlux(above), 1000.0 * 1.57);
  // In the floor's own plane there is nothing below it to light.
  const Lighting within = lit(emptyRoom(), panel({2.03, 2.71, 0.0}));
  EXPECT_EQ(directFlux(within), 0.0);
}

TEST(LightPlacement, BehindAWallIsDarkInside) {
  for (const dvec3& p : {dvec3(-0.5, 2, 1.5), dvec3(2, 2.5, 3.001), dvec3(2, 2, -0.2)}) {
    for (const auto& shape :
         {light::Shape(light::Sphere{0.1}), light::Shape(light::Rectangle{0.5, 0.5}),
          light::Shape(light::PointShape{})}) {
      if (std::holds_alternative<light::Sphere>(shape) && p.z > 3.0)
        continue;  // reaches into the room
      EXPECT_EQ(totalFlux(lit(emptyRoom(), with(shape, p))), 0.0);
    }
  }
}

TEST(LightPlacement, InsideASolidIsDarkOutside) {
  for (const auto& shape : {light::Shape(light::Rectangle{0.3, 0.3}),
                            light::Shape(light::Sphere{0.2}), light::Shape(light::PointShape{})}) {
    EXPECT_EQ(totalFlux(lit(furnishedRoom(), with(shape, {1.5, 1.6, 0.8}))), 0.0) << shape.index();
  }
}

TEST(LightPlacement, ASolidThatIsKnownToHoldALightIsARoom) {
  // The block of blockRoom() as a lit showcase: light inside, none outside.
  const auto solver = solverFor(blockRoom(), {dvec3(kRho)}, quickSettings(), {{1.5F, 1.6F, 0.8F}});
  const Lighting lighting = lit(solver, with(light::Rectangle{0.3, 0.3}, {1.5, 1.6, 0.8}));
  const transfer::Texels& texels = solver->operators().texels;
  const Planes total = lighting.total();
  double inside = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const vec3 p = texels.receivers.position(s) + 0.01F * texels.receivers.normal(s);
    if (p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2.2F && p.z > 0.3F && p.z < 1.3F) {
      inside += static_cast<double>(solver->operators().area[s]) * luminance(total, s);
    } else {
      ASSERT_EQ(luminance(total, s), 0.0) << s;
    }
  }
  // Midpoint rule with 15 cm cells at half a metre.
  EXPECT_NEAR(inside, 1000.0 / (1.0 - kRho), 0.03 * 1000.0 / (1.0 - kRho));
}

TEST(LightPlacement, HalfSunkIntoTheFloorAboutHalfIsLost) {
  // An upright panel, lower half below the floor: exactly half. Midpoint rule of 15 cm cells
  // beside a light of 40 cm.
  const auto panel = with(light::Rectangle{0.4, 0.4}, {2.0, 2.5, 0.0}, {0, -90, 0});
  EXPECT_NEAR(directFlux(lit(emptyRoom(), panel)), 500.0, 15.0);
  // A ball: its bit image is a disk through its centre (prepared_light.h), of which the floor hides
  // half from everywhere above, while of the ball (1 + sin h)/2 is seen from the height h. By the
  // disk 3/8 of the flux arrive (1/4 above, 1/8 on the floor), by the ball 1/2.
  const double ball = directFlux(lit(emptyRoom(), with(light::Sphere{0.2}, {2.03, 2.71, 0.0})));
  EXPECT_GT(ball, 0.97 * 375.0);
  EXPECT_LT(ball, 1.03 * 500.0);
}

TEST(LightPlacement, WithoutSizeItIsAPointWithACosine) {
  const auto sensors = blockRoomSensors();
  const Readings point =
      readIn(furnishedRoom(), {with(light::PointShape{}, {2.6, 2.9, 2.5})}, sensors);
  for (const double size : {1e-3, 1e-5, 1e-7}) {
    const Readings tiny =
        readIn(furnishedRoom(), {with(light::Rectangle{size, size}, {2.6, 2.9, 2.5})}, sensors);
    // Round-off of single precision; 1e-7 m is less than its step at 2.5 m (2.4e-7).
    const double tolerance = size > 1e-6 ? 1e-5 : 0.02;
    EXPECT_LT(relativeRms(tiny.direct, point.direct), tolerance) << size;
    EXPECT_LT(relativeRms(tiny.indirect, point.indirect), tolerance) << size;
  }
  for (const double size : {1e-3, 1e-5, 1e-7}) {
    // Midpoint rule with cells of 15 cm, 70 cm from the block: some parts in a thousand.
    EXPECT_NEAR(directFlux(lit(furnishedRoom(), with(light::Sphere{size}, {2.6, 2.9, 1.5}))),
                1000.0, 5.0)
        << size;
    EXPECT_NEAR(
        directFlux(lit(furnishedRoom(), with(light::Tube{10 * size, size}, {2.6, 2.9, 1.5}))),
        1000.0, 5.0)
        << size;
  }
}

TEST(LightPlacement, AWholeCeilingThatShines) {
  // Midpoint rule at the edge where walls meet the light: E is continuous there.
  EXPECT_NEAR(directFlux(lit(emptyRoom(), with(light::Rectangle{4.0, 5.0}, {2.0, 2.5, 3.0}))),
              1000.0, 5.0);
}

TEST(LightPlacement, LargerThanTheRoomOnlyItsPartInsideCounts) {
  const auto sensors = grid({0.2, 0.2, 0.8}, {3.6, 0, 0}, {0, 4.6, 0}, 6, 6);
  const Readings inside =
      readIn(emptyRoom(), {with(light::Rectangle{4.0, 5.0}, {2.0, 2.5, 2.9})}, sensors);
  for (const double size : {8.0, 20.0, 100.0}) {
    light::Luminaire huge = with(light::Rectangle{size, size}, {2.0, 2.5, 2.9});
    huge.flux = 1000.0 * size * size / 20.0;  // the same luminance
    const Readings found = readIn(emptyRoom(), {huge}, sensors);
    // The walls cut the light between its samples: at the finest 256 along one side, 128 along the
    // other, so half a sample of the 4 and 5 m that are seen, at either end.
    const double tolerance = size / 256 / 4.0 + size / 128 / 5.0;
    EXPECT_LT(relativeRms(found.direct, inside.direct), tolerance) << size;
    EXPECT_LT(relativeRms(found.indirect, inside.indirect), tolerance) << size;
  }
}

TEST(LightPlacement, ABallAroundTheRoomShinesAway) {
  EXPECT_EQ(totalFlux(lit(emptyRoom(), with(light::Sphere{50.0}, {2.0, 2.5, 1.5}))), 0.0);
}

}  // namespace
}  // namespace soffit::relight
