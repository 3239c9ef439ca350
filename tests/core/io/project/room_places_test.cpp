// SPDX-License-Identifier: MIT
#include "core/io/project/room_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soffit::io {
namespace {

using testing::ElementsAre;

geometry::Space living() {
  geometry::Space space;
  space.floor = 3.0F;
  space.height = 2.5F;
  space.center = {3.0F, 2.0F};
  space.corner = {0.5F, 0.5F};
  space.rectangle_lo = {0.0F, 0.0F};
  space.rectangle_hi = {6.0F, 4.0F};
  return space;
}

TEST(RoomPlaces, StandAndMeasureAboveTheRoomsOwnFloor) {
  const RoomPlaces places = roomPlaces({living()}, {"Living"}, {100.0, 0.0, 10.0});
  ASSERT_EQ(places.cameras.size(), 1U);
  EXPECT_EQ(places.cameras[0].name, "Living");
  // Rounded to centimetres: half of one each way.
  constexpr double kRounding = 0.0051;
  EXPECT_NEAR(places.cameras[0].position.x, 100.5, kRounding);
  EXPECT_NEAR(places.cameras[0].position.z, 14.6, kRounding);
  EXPECT_NEAR(places.cameras[0].target.x, 103.0, kRounding);
  const scene::WorkPlane& plane = places.work_planes.at(0);
  EXPECT_EQ(plane.name, "Living");
  EXPECT_NEAR(plane.origin.z, 13.8, kRounding);
  EXPECT_NEAR(plane.origin.x, 100.5, kRounding) << "half a metre off the wall";
  EXPECT_NEAR(plane.origin.y, 0.4, kRounding) << "a tenth of 4 m is less";
  EXPECT_NEAR(plane.u.x, 5.0, 2.0 * kRounding);
  EXPECT_NEAR(plane.v.y, 3.2, 2.0 * kRounding);
  EXPECT_EQ(plane.nu, 10);
  EXPECT_EQ(plane.nv, 6);
}

TEST(RoomPlaces, ARoomWithoutACornerIsLookedAtFromItsMiddle) {
  geometry::Space space = living();
  space.corner = space.center;
  const RoomPlaces places = roomPlaces({space}, {"Store"}, dvec3(0.0));
  EXPECT_NE(places.cameras.at(0).position, places.cameras.at(0).target);
}

TEST(RoomPlaces, RoomsAreCountedFromOne) {
  EXPECT_THAT(roomNames(2), ElementsAre("Room 1", "Room 2"));
}

}  // namespace
}  // namespace soffit::io
