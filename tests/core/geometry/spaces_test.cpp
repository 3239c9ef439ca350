// SPDX-License-Identifier: MIT
#include "core/geometry/spaces.h"

#include "core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::geometry {
namespace {

void add(Mesh& to, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), part.positions.begin(), part.positions.end());
  for (const uvec3& t : part.triangles) to.triangles.push_back(t + first);
}

/// Two rooms 2.8 m high, 6 x 4 and 3 x 4 m, with a wall of 0.2 m and an open door 2.1 m high
/// between them, in slabs of 0.3 m; a table stands in the first.
Mesh flat(float base = 0.0F) {
  Mesh mesh;
  const auto box = [&](vec3 lo, vec3 hi) {
    lo.z += base;
    hi.z += base;
    add(mesh, makeBox(lo, hi));
  };
  box({-0.2F, -0.2F, -0.3F}, {9.4F, 4.2F, 0.0F});
  box({-0.2F, -0.2F, 2.8F}, {9.4F, 4.2F, 3.1F});
  box({-0.2F, -0.2F, 0.0F}, {0.0F, 4.2F, 2.8F});
  box({9.2F, -0.2F, 0.0F}, {9.4F, 4.2F, 2.8F});
  box({0.0F, -0.2F, 0.0F}, {9.2F, 0.0F, 2.8F});
  box({0.0F, 4.0F, 0.0F}, {9.2F, 4.2F, 2.8F});
  box({6.0F, 0.0F, 0.0F}, {6.2F, 1.5F, 2.8F});
  box({6.0F, 2.5F, 0.0F}, {6.2F, 4.0F, 2.8F});
  box({6.0F, 1.5F, 2.1F}, {6.2F, 2.5F, 2.8F});
  box({2.0F, 1.0F, 0.70F}, {4.0F, 2.0F, 0.75F});
  return mesh;
}

std::vector<Space> spacesOf(const Mesh& mesh) {
  return findSpaces(mesh, RayCaster(mesh.positions, mesh.triangles));
}

// Truncation: a wall between two cells' centers is found to one cell.
constexpr float kCell = 0.16F;

TEST(FindSpaces, AnOpenDoorPartsRoomsAndATableDoesNot) {
  const auto spaces = spacesOf(flat());
  ASSERT_EQ(spaces.size(), 2U);
  // A band of one cell along all walls is uncertain.
  EXPECT_NEAR(spaces[0].area, 24.0F, 20.0F * kCell);
  EXPECT_NEAR(spaces[1].area, 12.0F, 14.0F * kCell + 1.0F);
  for (const Space& s : spaces) {
    EXPECT_NEAR(s.floor, 0.0F, 1e-3F);
    EXPECT_NEAR(s.height, 2.8F, 1e-3F);
  }
  EXPECT_NEAR(spaces[0].center.x, 3.0F, 1.1F);
  EXPECT_NEAR(spaces[0].center.y, 2.0F, kCell);
  EXPECT_NEAR(spaces[1].center.x, 7.7F, kCell);
  EXPECT_NEAR(spaces[0].rectangle_lo.x, 0.0F, kCell);
  EXPECT_NEAR(spaces[0].rectangle_hi.x, 6.0F, kCell);
  EXPECT_NEAR(spaces[0].rectangle_hi.y, 4.0F, kCell);
}

TEST(FindSpaces, TheCornerIsInTheRoomAndOffItsWalls) {
  const auto spaces = spacesOf(flat());
  ASSERT_EQ(spaces.size(), 2U);
  for (const Space& s : spaces) {
    EXPECT_GT(glm::distance(s.corner, s.center), 1.5F);
    for (int k = 0; k < 2; ++k) {
      EXPECT_GE(s.corner[k], s.box.lo[k] + 0.35F - kCell);
      EXPECT_LE(s.corner[k], s.box.hi[k] - 0.35F + kCell);
    }
  }
}

TEST(FindSpaces, StoreysComeFromBelow) {
  Mesh house = flat();
  add(house, flat(3.1F));
  const auto spaces = spacesOf(house);
  ASSERT_EQ(spaces.size(), 4U);
  EXPECT_NEAR(spaces[1].floor, 0.0F, 1e-3F);
  EXPECT_NEAR(spaces[2].floor, 3.1F, 1e-3F);
  EXPECT_GT(spaces[2].area, spaces[3].area);
}

TEST(FindSpaces, AnObjectInTheOpenHasNone) {
  EXPECT_TRUE(spacesOf(makeRectangle(4.0F, 4.0F)).empty());
  EXPECT_TRUE(spacesOf(Mesh{}).empty());
  // A roof on posts has headroom but no walls.
  Mesh carport = makeBox({0, 0, -0.2F}, {6, 6, 0});
  add(carport, makeBox({0, 0, 2.5F}, {6, 6, 2.7F}));
  EXPECT_TRUE(spacesOf(carport).empty());
}

TEST(FindSpaces, TheInsideOfWallsIsNoRoom) {
  // Eight metres of hollow wall, 0.4 m thick: enough area, but no room.
  EXPECT_TRUE(spacesOf(makeBox({0, 0, 0}, {8.0F, 0.4F, 2.8F})).empty());
}

}  // namespace
}  // namespace soffit::geometry
