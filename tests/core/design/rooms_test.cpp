// SPDX-License-Identifier: MIT
#include "core/design/rooms.h"

#include "tests/core/design/scenes.h"

namespace soffit::design {
namespace {

using namespace testing;

geometry::RayCaster casterOf(const scene::Scene& scene) {
  return {scene.mesh->positions, scene.mesh->triangles};
}

TEST(FindRooms, ADoorwayParts) {
  const scene::Scene scene = twoRooms();
  const auto rooms = findRooms(casterOf(scene), scene.mesh->origin, scene.work_planes);
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[0].name, "Left");
  EXPECT_EQ(rooms[1].name, "Right");
  for (const vec3& p : rooms[1].points) {
    EXPECT_TRUE(p.x > 3.0F && p.x < 6.0F && p.y > 0.0F && p.y < 4.0F && p.z > 0.0F && p.z < 3.0F);
  }
}

TEST(FindRooms, PlanesOfOneRoomBelongTogether) {
  scene::Scene scene = blockRoom();
  scene.work_planes.push_back(scene.work_planes[0]);
  scene.work_planes[1].name = "Bench";
  scene.work_planes[1].origin = {0.2, 3.0, 0.4};
  const auto rooms = findRooms(casterOf(scene), scene.mesh->origin, scene.work_planes);
  ASSERT_EQ(rooms.size(), 1U);
  EXPECT_EQ(rooms[0].name, "Table + Bench");
  EXPECT_EQ(rooms[0].planes, (std::vector<std::size_t>{0, 1}));
}

TEST(FindRooms, AnOpeningUpToTheCeilingJoins) {
  scene::Scene scene = twoRooms();
  auto mesh = std::make_shared<geometry::Mesh>(*scene.mesh);
  mesh->triangles.resize(mesh->triangles.size() - 2);  // the wall over the door
  scene.mesh = mesh;
  EXPECT_EQ(findRooms(casterOf(scene), scene.mesh->origin, scene.work_planes).size(), 1U);
}

TEST(FindRooms, WorksInWorldCoordinatesFarAway) {
  scene::Scene scene = twoRooms();
  const dvec3 far(4e6, 5e6, 100.0);
  auto mesh = std::make_shared<geometry::Mesh>(*scene.mesh);
  mesh->origin = far;
  scene.mesh = mesh;
  for (auto& plane : scene.work_planes) plane.origin += far;
  EXPECT_EQ(findRooms(casterOf(scene), far, scene.work_planes).size(), 2U);
}

TEST(AssignRooms, GivesEachPointTheRoomItSeesMostOf) {
  const scene::Scene scene = twoRooms();
  const auto caster = casterOf(scene);
  const auto rooms = findRooms(caster, scene.mesh->origin, scene.work_planes);
  // Walls, both sides of the partition, and one point that looks out of the model.
  const std::vector<dvec3> positions{
      {0.0, 2.0, 1.5}, {6.0, 2.0, 1.5}, {3.0, 1.0, 1.0}, {3.0, 1.0, 1.0}, {0.0, 2.0, 1.5}};
  const std::vector<dvec3> normals{{1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(assignRooms(caster, rooms, positions, normals),
            (std::vector<std::size_t>{0, 1, 0, 1, kNoRoom}));
}

}  // namespace
}  // namespace soffit::design
