// SPDX-License-Identifier: MIT
// Rooms that are easy to draw and hard to light: what must hold in them whatever the bake.
#include "core/relight/bodies.h"
#include "tests/core/relight/readings.h"

#include <algorithm>

namespace soffit::relight {
namespace {

using namespace testing;

/// Two rooms of 3 x 4 x 3 m with a wall of 12 cm between them, its doorway shut by a leaf that
/// sinks 2 mm into what is around it.
std::shared_ptr<geometry::Mesh> shutRooms() {
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {6.12F, 4, 3}, true, 0);
  const float e = 0.002F;
  addBox(*mesh, {3, -e, -e}, {3.12F, 1.5F, 3 + e}, false, 0);
  addBox(*mesh, {3, 2.4F, -e}, {3.12F, 4 + e, 3 + e}, false, 0);
  addBox(*mesh, {3, 1.5F - e, 2.1F}, {3.12F, 2.4F + e, 3 + e}, false, 0);
  addBox(*mesh, {3.04F, 1.5F - e, -e}, {3.08F, 2.4F + e, 2.1F + e}, false, 0);
  return mesh;
}

TEST(ShutDoor, NothingComesThrough) {
  auto settings = quickSettings();
  // Fine cells, a quarter of a cell wide, must tell the sides of a leaf of 4 cm apart.
  settings.texels = 52000;
  const auto solver = solverFor(shutRooms(), {dvec3(0.8)}, settings, {{1.5F, 2, 1}, {4.6F, 2, 1}});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({1.5, 2.0, 2.9}, 0.6, 3000)}).ok());
  std::vector<scene::Sensor> left = grid({0.2, 0.2, 0.8}, {2.6, 0, 0}, {0, 3.6, 0}, 5, 6);
  std::vector<scene::Sensor> right = grid({3.32, 0.2, 0.8}, {2.6, 0, 0}, {0, 3.6, 0}, 5, 6);
  const Readings lit = read(lighting, left);
  const Readings dark = read(lighting, right);
  EXPECT_GT(mean(lit.direct), 50.0);
  for (const double e : dark.direct) EXPECT_EQ(e, 0.0);
  for (const double e : dark.indirect) EXPECT_LE(e, 1e-4 * mean(lit.indirect));
  const Planes total = lighting.total();
  const transfer::Texels& texels = solver->operators().texels;
  double worst = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const vec3 p = texels.receivers.position(s) + 0.01F * texels.receivers.normal(s);
    if (p.x > 3.12F && p.x < 6.12F && p.y > 0 && p.y < 4 && p.z > 0 && p.z < 3) {
      worst = std::max(worst, luminance(total, s));
    }
  }
  EXPECT_LE(worst, 1e-4 * mean(lit.indirect));
}

TEST(Solids, ATubeInsideLightsNothingOutside) {
  // Seen end-on from the wall x = 0, through two faces of the block.
  const auto solver = solverFor(blockRoom(), {dvec3(0.6)});
  light::Luminaire tube = panel({1.5, 1.6, 0.8});
  tube.shape = light::Tube{0.4, 0.02};
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{tube}).ok());
  EXPECT_EQ(directFlux(lighting), 0.0);
}

TEST(Light, IsNeverNegative) {
  // An upright panel in the plane of a wall: beside it the indirect light is small and uneven.
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  Lighting lighting(solverFor(mesh, {dvec3(0.6)}));
  light::Luminaire upright = panel({0.0, 0.3, 0.3});
  upright.rotation_deg = {0, -90, 0};
  ASSERT_TRUE(lighting.setLuminaires(std::vector{upright}).ok());
  const Planes total = lighting.total();
  float least = 0.0F;
  for (const float e : total[1]) least = std::min(least, e);
  EXPECT_EQ(least, 0.0F);  // lux
}

TEST(SmallRooms, AreLitThoughTheLeastCellIsLarger) {
  // A model in metres that was meant in millimetres: a room of 4 mm and cells of at least 3 cm.
  auto mesh = blockRoom();
  for (vec3& p : mesh->positions) p *= 1e-3F;
  light::Luminaire small = panel(dvec3(2.6, 2.9, 2.6) * 1e-3);
  small.scale = 1e-3;
  std::vector<scene::Sensor> sensors = blockRoomSensors();
  const Readings expected =
      readIn(solverFor(blockRoom(), {dvec3(0.6)}), {panel({2.6, 2.9, 2.6})}, sensors);
  for (scene::Sensor& s : sensors) s.position *= 1e-3;
  const Readings found = readIn(solverFor(mesh, {dvec3(0.6)}), {small}, sensors);
  EXPECT_LT(relativeRms(found.direct, expected.direct, 1e-6), 1.0 / 512);
  // One texel a face would be the average at best.
  EXPECT_LT(relativeRms(found.indirect, expected.indirect, 1e-6), 0.3);
}

TEST(Void, AHutThatSeesNothingIsLeftOut) {
  // A building beside the room: no side of it sees anything, so none carries light.
  auto mesh = blockRoom();
  addBox(*mesh, {10, 10, 0}, {12, 12, 2}, false, 0);
  const std::vector<light::Luminaire> lamp = {panel({2.6, 2.9, 2.6})};
  const auto sensors = blockRoomSensors();
  const Readings alone = readIn(solverFor(blockRoom(), {dvec3(0.6)}), lamp, sensors);
  const Readings found =
      readIn(solverFor(mesh, {dvec3(0.6)}, quickSettings(), {{3, 3, 1}}), lamp, sensors);
  EXPECT_LT(relativeRms(found.direct, alone.direct), 1e-6);
  EXPECT_LT(relativeRms(found.indirect, alone.indirect), 1e-2);  // other rays: noise
}

TEST(Polygons, CastShadowsLikeOtherShapes) {
  light::Luminaire l = panel({2, 2.5, 1.5});
  l.shape = light::Polygon{{{0, 0}, {0.9, 0}, {0.9, 0.3}, {0.3, 0.3}, {0.3, 0.9}, {0, 0.9}}};
  l.casts_shadow = true;
  const auto emitter = light::makeEmitter(l);
  ASSERT_TRUE(emitter.ok());
  double area = 0.0;
  for (const light::MaskBlocker& b : bodyBlockers(*emitter)) {
    dvec3 sum(0.0);
    for (int i = 1; i + 1 < b.count; ++i) {
      const dvec3 a(b.corners[0]);
      sum += 0.5 * glm::cross(dvec3(b.corners[static_cast<std::size_t>(i)]) - a,
                              dvec3(b.corners[static_cast<std::size_t>(i + 1)]) - a);
    }
    area += glm::length(sum);
  }
  EXPECT_NEAR(area, 0.45, 1e-6);
}

TEST(Void, TheFarSideOfAFloorThatFurnitureSinksIntoIsDark) {
  auto mesh = blockRoom();
  addBox(*mesh, {2.4F, 3.1F, -0.002F}, {3.37F, 4.46F, 0.9F}, false, 0);
  const auto solver = solverFor(mesh, {dvec3(0.5)}, quickSettings(), {{3, 1, 1}});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({2.6, 2.9, 2.6})}).ok());
  const Planes total = lighting.total();
  const transfer::Texels& texels = solver->operators().texels;
  int outside = 0;
  double worst = 0.0;
  double lit = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    lit += luminance(total, s) / static_cast<double>(texels.slotCount());
    if (texels.receivers.position(s).z >= 0.001F || texels.receivers.normal(s).z >= 0) continue;
    ++outside;
    worst = std::max(worst, luminance(total, s));
  }
  EXPECT_GT(outside, 0);
  EXPECT_GT(lit, 0.0);
  // Rays that end on the 2 mm of the furniture below the floor, whose texels are lit above it, are
  // too few to count.
  EXPECT_EQ(worst, 0.0);
}

}  // namespace
}  // namespace soffit::relight
