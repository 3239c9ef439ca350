// SPDX-License-Identifier: MIT
#include "core/relight/sensor_readings.h"

#include "tests/core/relight/readings.h"

#include <stop_token>

namespace soffit::relight {
namespace {

using namespace testing;

const std::shared_ptr<const Solver>& room() {
  static const auto solver = solverFor(blockRoom(), {dvec3(0.6, 0.5, 0.4)});
  return solver;
}

std::vector<light::Luminaire> threeLights() {
  std::vector<light::Luminaire> lights{panel({2.5, 2.5, 2.9}), panel({1, 4, 2.5}),
                                       panel({3.5, 1, 2.9}, 0.3, 400.0)};
  lights[1].colour.rgb = dvec3(1.0, 0.6, 0.3);
  lights[2].dimming = 0.4;
  return lights;
}

/// Rays as in the tests of Sensors; few, for both sides shoot the same.
constexpr int kRays = 16;

void expectAsLightingReads(SensorReadings& readings, const std::shared_ptr<const Solver>& solver,
                           const std::vector<light::Luminaire>& lights) {
  const auto sensors = blockRoomSensors();
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(lights).ok());
  const auto expected = lighting.read(Sensors(*solver, sensors, Quantity::planar, kRays, 1));
  const auto found = readings.read(lighting.emitters());
  ASSERT_TRUE(found.ok());
  ASSERT_EQ(found->size(), expected.size());
  // Sums in another order, single precision: some hundred additions per gather list.
  constexpr double kRoundoff = 500 * 6e-8;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR((*found)[i].direct[c], expected[i].direct[c],
                  kRoundoff * (1.0 + expected[i].direct[c]));
      EXPECT_NEAR((*found)[i].indirect[c], expected[i].indirect[c],
                  kRoundoff * (1.0 + expected[i].indirect[c]));
    }
  }
}

TEST(SensorReadings, ReadWhatLightingReadsThroughMovesDimmingAndPaint) {
  SensorReadings readings(blockRoomSensors(), kRays, 1);
  readings.setSolver(room());
  auto lights = threeLights();
  expectAsLightingReads(readings, room(), lights);
  lights[0].position.x = 1.7;
  lights[1].dimming = 0.5;
  lights[2].on = false;
  expectAsLightingReads(readings, room(), lights);
  lights.erase(lights.begin());
  expectAsLightingReads(readings, room(), lights);

  scene::Material dark;
  dark.diffuse = dvec3(0.1);
  const auto repainted = room()->repainted(std::vector{dark});
  readings.setSolver(repainted);
  expectAsLightingReads(readings, repainted, lights);
}

TEST(SensorReadings, ABodyThatMovesChangesTheShadowsOfAll) {
  SensorReadings readings(blockRoomSensors(), kRays, 1);
  readings.setSolver(room());
  auto lights = threeLights();
  lights[1].casts_shadow = true;
  expectAsLightingReads(readings, room(), lights);
  lights[1].position = {2.5, 2.4, 2.0};
  expectAsLightingReads(readings, room(), lights);
  lights[1].casts_shadow = false;
  expectAsLightingReads(readings, room(), lights);
}

TEST(SensorReadings, WithoutASolverOrCancelledTheySaySo) {
  SensorReadings readings(blockRoomSensors(), kRays, 1);
  EXPECT_FALSE(readings.read({}).ok());
  readings.setSolver(room());
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(threeLights()).ok());
  std::stop_source stop;
  stop.request_stop();
  const auto cancelled =
      readings.read(lighting.emitters(), nullptr, Job{nullptr, stop.get_token()});
  ASSERT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.error().what, "cancelled");
}

}  // namespace
}  // namespace soffit::relight
