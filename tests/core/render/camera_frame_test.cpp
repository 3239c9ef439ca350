// SPDX-License-Identifier: MIT
#include "core/render/camera_frame.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::render {
namespace {

constexpr double kRoundoff = 1e-9;

scene::Camera camera(const dvec3& position, const dvec3& target, double fov = 90.0) {
  return {.name = "A", .position = position, .target = target, .vertical_fov_deg = fov};
}

TEST(CameraFrame, PutsKnownPointsOnKnownPixels) {
  // Looks along +y; 90 degrees: half the height at depth d is d.
  const auto frame = CameraFrame::create(camera({1, 2, 3}, {1, 7, 3}), 200, 100).value();
  const auto expect = [&](const dvec3& point, const dvec3& place) {
    const dvec3 p = frame.project(point);
    EXPECT_NEAR(p.x, place.x, kRoundoff);
    EXPECT_NEAR(p.y, place.y, kRoundoff);
    EXPECT_NEAR(p.z, place.z, kRoundoff);
  };
  expect({1, 4, 3}, {100, 50, 2});
  expect({1, 4, 5}, {100, 0, 2});   // up is the top of the picture
  expect({2, 4, 3}, {125, 50, 2});  // +x is to the right of somebody who looks along +y
  expect({-1, 12, 8}, {90, 25, 10});
  EXPECT_LT(frame.project({1, 1, 3}).z, 0.0);
}

TEST(CameraFrame, RaysAndProjectionUndoEachOther) {
  const auto frame =
      CameraFrame::create(camera({4, -1, 1.6}, {0.3, 2, 0.9}, 47.0), 641, 399).value();
  for (const dvec2 at :
       {dvec2(0.5, 0.5), dvec2(320.5, 199.5), dvec2(640.9, 3.25), dvec2(17, 398)}) {
    const geometry::Ray ray = frame.ray(at.x, at.y);
    EXPECT_NEAR(glm::length(ray.direction), 1.0F, 1e-6F);
    const dvec3 back = frame.project(dvec3(ray.origin) + 3.0 * dvec3(ray.direction));
    // Round-off of a single precision direction, in pixels.
    EXPECT_NEAR(back.x, at.x, 2e-4);
    EXPECT_NEAR(back.y, at.y, 2e-4);
  }
}

TEST(CameraFrame, LooksStraightDownWithNorthUp) {
  const auto frame = CameraFrame::create(camera({5, 5, 10}, {5, 5, 0}), 100, 100).value();
  EXPECT_LT(frame.project({5, 6, 0}).y, 50.0);
  EXPECT_GT(frame.project({6, 5, 0}).x, 50.0);
}

TEST(CameraFrame, IsRelativeToTheScenesOrigin) {
  const dvec3 far(4.5e5, 5.4e6, 100.0);
  const auto here = CameraFrame::create(camera({1, 2, 3}, {4, 4, 2}), 64, 48).value();
  const auto there =
      CameraFrame::create(camera(dvec3(1, 2, 3) + far, dvec3(4, 4, 2) + far), 64, 48, far).value();
  EXPECT_NEAR(glm::length(here.ray(10, 20).direction - there.ray(10, 20).direction), 0.0F, 1e-6F);
  EXPECT_NEAR(glm::length(here.ray(10, 20).origin - there.ray(10, 20).origin), 0.0F, 1e-6F);
}

TEST(CameraFrame, SaysWhatIsWrong) {
  const auto message = [](const scene::Camera& c, int w, int h) {
    return CameraFrame::create(c, w, h).error().message();
  };
  EXPECT_EQ(
      message(camera({0, 0, 0}, {1, 0, 0}), 0, 600),
      "size: expected 1 to 32768 pixels a side, found 0 x 600. Ask for a size such as 1280x800.");
  EXPECT_EQ(message(camera({1, 0, 0}, {1, 0, 0}), 8, 6),
            "cameras.A: the target is at the camera's own position. Move the target to what is "
            "looked at.");
  EXPECT_EQ(message(camera({1, 0, 0}, {2, 0, 0}, 180.0), 8, 6),
            "cameras.A.vertical_fov: expected 0.1 to 179 degrees, found 180. 50 is a usual angle.");
  EXPECT_EQ(message(camera({1, 0, std::numeric_limits<double>::infinity()}, {2, 0, 0}), 8, 6),
            "cameras.A: expected finite numbers for position and target. Correct the numbers.");
  EXPECT_FALSE(CameraFrame::create(camera({1, 0, 0}, {2, 0, 0}, std::nan("")), 8, 6).ok());
}

}  // namespace
}  // namespace soffit::render
