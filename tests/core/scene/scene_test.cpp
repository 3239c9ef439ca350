// SPDX-License-Identifier: MIT
#include "core/scene/scene.h"

#include "tests/core/scene/example_scene.h"

#include <gtest/gtest.h>

namespace soffit::scene {
namespace {

TEST(ResolveLayout, EditsChangeOnlyTheFieldsTheyName) {
  const Scene scene = exampleScene();
  const auto resolved = resolveLayout(scene, scene.layouts[1]);
  ASSERT_EQ(resolved.size(), 3U);
  EXPECT_EQ(resolved[0].name, "Panel");
  EXPECT_EQ(resolved[0].dimming, 0.25);
  EXPECT_EQ(resolved[0].position, dvec3(1, 2, 3));
  EXPECT_EQ(resolved[0].flux, 3000.0);
  EXPECT_EQ(resolved[1].name, "Lamp");
  EXPECT_EQ(resolved[1].dimming, 1.0);
}

TEST(ResolveLayout, NamesThatTheBaseLacksAreLuminairesOfThatLayoutAlone) {
  const Scene scene = exampleScene();
  const auto resolved = resolveLayout(scene, scene.layouts[1]);
  EXPECT_EQ(resolved[2].name, "Candle");
  EXPECT_TRUE(std::holds_alternative<light::PointShape>(resolved[2].shape));
  EXPECT_EQ(resolveLayout(scene, scene.layouts[0]).size(), 2U);
}

TEST(SensorsOf, AreCellCentersWithTheFirstAxisFastest) {
  const WorkPlane plane{"P", {1, 2, 0.8}, {4, 0, 0}, {0, 2, 0}, 4, 2, ""};
  const auto sensors = sensorsOf(plane);
  ASSERT_EQ(sensors.size(), 8U);
  // Halves and quarters: exact in binary.
  EXPECT_EQ(sensors[0].position, dvec3(1.5, 2.5, 0.8));
  EXPECT_EQ(sensors[1].position, dvec3(2.5, 2.5, 0.8));
  EXPECT_EQ(sensors[4].position, dvec3(1.5, 3.5, 0.8));
  EXPECT_EQ(sensors[7].position, dvec3(4.5, 3.5, 0.8));
  for (const Sensor& sensor : sensors) EXPECT_EQ(sensor.normal, dvec3(0, 0, 1));
}

TEST(SensorsOf, NormalIsUCrossV) {
  const WorkPlane plane{"P", {0, 0, 0}, {0, 2, 0}, {3, 0, 0}, 1, 1, ""};
  EXPECT_EQ(sensorsOf(plane).front().normal, dvec3(0, 0, -1));
}

}  // namespace
}  // namespace soffit::scene
