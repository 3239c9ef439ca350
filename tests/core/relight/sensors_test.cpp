// SPDX-License-Identifier: MIT
#include "core/relight/sensors.h"

#include "tests/core/relight/readings.h"

#include <numbers>

namespace soffit::relight {
namespace {

using namespace testing;

const std::shared_ptr<const Solver>& room() {
  static const auto solver = solverFor(blockRoom(), {dvec3(0.6)});
  return solver;
}

/// Direct lux of a far small ball straight in direction `to` of the sensor, relative to its planar
/// illuminance when faced.
double share(Quantity quantity, const dvec3& n, const dvec3& to) {
  scene::Scene scene;
  const auto empty = solverFor(std::make_shared<geometry::Mesh>(), {});
  light::Luminaire l = panel(100.0 * to);
  l.shape = light::Sphere{0.01};
  Lighting lighting(empty);
  EXPECT_TRUE(lighting.setLuminaires(std::vector{l}).ok());
  const std::vector<scene::Sensor> sensors = {{dvec3(0.0), n}};
  const std::vector<scene::Sensor> faced = {{dvec3(0.0), to}};
  const Sensors asked(*empty, sensors, quantity, 8, 1);
  const Sensors planar(*empty, faced, Quantity::planar, 8, 1);
  return lighting.read(asked)[0].direct.y / lighting.read(planar)[0].direct.y;
}

TEST(SensorQuantities, OfOneDistantLightAreTheirClosedForms) {
  const dvec3 up(0, 0, 1);
  const dvec3 side(1, 0, 0);
  // The mean over all orientations of max(cos, 0) is 1/4; over a half sphere about the light 1/2.
  EXPECT_NEAR(share(Quantity::spherical, up, up), 0.25, 0.005);
  EXPECT_NEAR(share(Quantity::hemispherical, up, up), 0.5, 0.005);
  EXPECT_NEAR(share(Quantity::hemispherical, up, side), 0.25, 0.01);
  // Around a vertical axis a light at the horizon gives 1/pi, one overhead nothing.
  EXPECT_NEAR(share(Quantity::cylindrical, up, side), 1.0 / std::numbers::pi, 0.005);
  EXPECT_NEAR(share(Quantity::cylindrical, up, up), 0.0, 1e-4);  // the ball is 1e-4 wide
  // Half around: faced, the mean of cos over +-90 degrees, 2/pi; from behind, nothing.
  EXPECT_NEAR(share(Quantity::semicylindrical, side, side), 2.0 / std::numbers::pi, 0.005);
  EXPECT_NEAR(share(Quantity::semicylindrical, side, -side), 0.0, 1e-4);
  EXPECT_NEAR(share(Quantity::planar, up, glm::normalize(dvec3(1, 0, 1))), std::sqrt(0.5), 1e-6);
}

TEST(Sensors, OnASurfaceReadTheSideTheyFace) {
  // On the block's top, and on a wall, exactly.
  const std::vector<scene::Sensor> on = {{{1.5, 1.6, 1.3}, {0, 0, 1}}, {{0, 2.5, 1}, {1, 0, 0}}};
  const std::vector<scene::Sensor> above = {{{1.5, 1.6, 1.301}, {0, 0, 1}},
                                            {{0.001, 2.5, 1}, {1, 0, 0}}};
  const Readings a = readIn(room(), {panel({2.5, 2.5, 2.9})}, on);
  const Readings b = readIn(room(), {panel({2.5, 2.5, 2.9})}, above);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(a.direct[i], 1.0);
    EXPECT_NEAR(a.direct[i], b.direct[i], 5e-3 * b.direct[i]);  // a millimetre in a metre
    EXPECT_NEAR(a.indirect[i], b.indirect[i], 0.02 * b.indirect[i]);
  }
}

TEST(Sensors, MoreRaysAndOtherSeedsAgreeWithinTheirNoise) {
  const auto sensors = blockRoomSensors();
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({2.5, 2.5, 2.9})}).ok());
  std::array<std::vector<double>, 2> found;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Sensors ready(*room(), sensors, Quantity::planar, 64, seed);
    for (const SensorLight& l : lighting.read(ready)) found[seed - 1].push_back(l.indirect.y);
  }
  EXPECT_GT(relativeRms(found[0], found[1]), 0.0);
  // 4096 stratified rays: N^-3/4 is 0.2 %; two of them, three times that.
  EXPECT_LT(relativeRms(found[0], found[1]), 0.006);
}

TEST(Sensors, NoneIsNoneAndOneLuminaireIsAPart) {
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({2.5, 2.5, 2.9}), panel({1, 4, 2.5})}).ok());
  const Sensors none(*room(), {}, Quantity::planar, 8, 1);
  EXPECT_EQ(none.size(), 0U);
  EXPECT_TRUE(lighting.read(none).empty());
  const auto sensors = blockRoomSensors();
  const Sensors ready(*room(), sensors, Quantity::planar, 16, 1);
  const auto all = lighting.read(ready);
  const auto first = lighting.read(ready, 0);
  const auto second = lighting.read(ready, 1);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    EXPECT_NEAR(all[i].direct.y, first[i].direct.y + second[i].direct.y, 1e-6 * all[i].direct.y);
    EXPECT_NEAR(all[i].indirect.y, first[i].indirect.y + second[i].indirect.y,
                1e-5 * all[i].indirect.y);
  }
}

}  // namespace
}  // namespace soffit::relight
