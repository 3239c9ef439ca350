// SPDX-License-Identifier: MIT
#include "core/io/project/starting_place.h"

#include "core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::io {
namespace {

TEST(StartingPlace, StandsInTheRoomAtEyeHeight) {
  const geometry::Mesh room = geometry::makeBox({0, 0, 0}, {6, 4, 2.8F});
  const StartingPlace start = startingPlace(room);
  // The camera is rounded to centimetres.
  constexpr double kRounding = 0.0051;
  EXPECT_NEAR(start.camera.position.z, 1.6, kRounding);
  EXPECT_GE(start.camera.position.x, 0.3);
  EXPECT_LE(start.camera.position.x, 5.7);
  EXPECT_NE(start.camera.position, start.camera.target);
  ASSERT_TRUE(start.work_plane.has_value());
  const scene::WorkPlane& plane = *start.work_plane;
  // A tenth of 4 m is less than half a metre; sides and origin are rounded each.
  EXPECT_NEAR(plane.origin.x, 0.5, 2 * kRounding);
  EXPECT_NEAR(plane.origin.y, 0.4, 2 * kRounding);
  EXPECT_NEAR(plane.origin.z, 0.8, kRounding);
  EXPECT_NEAR(plane.u.x, 5.0, 2 * kRounding);
  EXPECT_NEAR(plane.v.y, 3.2, 2 * kRounding);
  EXPECT_EQ(plane.nu, 10);
  EXPECT_EQ(plane.nv, 6);
}

TEST(StartingPlace, FollowsTheModelsOrigin) {
  geometry::Mesh room = geometry::makeBox({0, 0, 0}, {6, 4, 2.8F});
  const StartingPlace near = startingPlace(room);
  room.origin = {1000, 2000, 50};
  const StartingPlace far = startingPlace(room);
  constexpr double kRounding = 0.0101;  // both are rounded to centimetres
  EXPECT_LT(glm::distance(far.camera.position, near.camera.position + room.origin), kRounding);
}

TEST(StartingPlace, InTheOpenItLooksFromOutside) {
  const geometry::Mesh sheet = geometry::makeRectangle(2, 2);
  const StartingPlace start = startingPlace(sheet);
  EXPECT_FALSE(start.work_plane.has_value());
  EXPECT_GT(glm::length(start.camera.position), std::sqrt(2.0)) << "beyond the corners";
  EXPECT_EQ(start.camera.target, dvec3(0.0));
}

}  // namespace
}  // namespace soffit::io
