// SPDX-License-Identifier: MIT
// What stands on or over a surface, and how much of a texel that leaves.
#include "core/transfer/exposure.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

/// A room of 4 x 3 x 2.5 m with one box in it; the room is known to be one.
std::shared_ptr<const StaticScene> roomWith(const vec3& lo, const vec3& hi) {
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox(lo, hi), 1);
  const std::vector<vec3> inside = {{0.5F, 0.5F, 2.0F}};
  return makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
}

Cover coverAt(const StaticScene& scene, const vec3& p, const vec3& n, float gap) {
  return coverOf(*scene.mesh, scene.sides, scene.caster, p, n, gap);
}

TEST(CoverOf, TellsTheOpenFromGapsAndMatter) {
  const auto standing = roomWith({1, 1, -0.002F}, {2, 2, 0.8F});
  const vec3 up(0, 0, 1);
  EXPECT_EQ(coverAt(*standing, {0.5F, 0.5F, 0}, up, 0.05F), Cover::none);
  EXPECT_EQ(coverAt(*standing, {1.5F, 1.5F, 0}, up, 0.05F), Cover::matter);   // under the cabinet
  EXPECT_EQ(coverAt(*standing, {1.5F, 1.5F, 0.8F}, up, 0.05F), Cover::none);  // on top of it
  const auto hovering = roomWith({1, 1, 0.01F}, {2, 2, 0.8F});
  EXPECT_EQ(coverAt(*hovering, {1.5F, 1.5F, 0}, up, 0.05F), Cover::gap);
  EXPECT_EQ(coverAt(*hovering, {1.5F, 1.5F, 0}, up, 0.005F), Cover::none);     // farther than asked
  EXPECT_EQ(coverAt(*hovering, {1.5F, 1.5F, 0.01F}, -up, 0.05F), Cover::gap);  // its underside
}

/// Area of what looks up at height z.
double areaUp(const Texels& texels, float z) {
  double area = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    if (texels.receivers.normal(s).z > 0.9F &&
        std::abs(texels.receivers.position(s).z - z) < 1e-3F) {
      area += static_cast<double>(texels.area[s]);
    }
  }
  return area;
}

TEST(Exposure, AFloorCountsWithoutTheFootprint) {
  for (const double cell : {0.2, 0.1, 0.053}) {
    const auto scene = roomWith({1.03F, 1.02F, -0.002F}, {2.21F, 1.87F, 0.8F});
    const Texels texels = makeTexels(*scene->mesh, scene->sides, cell, &scene->caster);
    const double footprint = 1.18 * 0.85;
    // 16 samples a cell: along the outline the area is off by an eighth of a cell at most, on
    // either side of the box.
    const double tolerance = 2 * (1.18 + 0.85) * cell / 8;
    EXPECT_NEAR(areaUp(texels, 0.0F), 12.0 - footprint, tolerance) << cell;
    EXPECT_NEAR(areaUp(texels, 0.8F), footprint, 1e-4);
  }
}

TEST(Exposure, NothingOfAWallIsLeftWithinASlabThatEndsAtIt) {
  // A ceiling from wall to wall: its ends coincide with the walls, and a ray that runs through the
  // slab meets either.
  const auto scene = roomWith({0, 0, 2.0F}, {4, 3, 2.06F});
  for (const double cell : {0.21, 0.13, 0.087}) {
    const Texels texels = makeTexels(*scene->mesh, scene->sides, cell, &scene->caster);
    double within = 0.0;
    double below = 0.0;
    for (std::size_t s = 0; s < texels.slotCount(); ++s) {
      const vec3 p = texels.receivers.position(s);
      if (std::abs(texels.receivers.normal(s).z) > 0.1F) continue;
      if (p.z > 2.0F && p.z < 2.06F) within += static_cast<double>(texels.area[s]);
      if (p.z < 2.0F) below += static_cast<double>(texels.area[s]);
    }
    EXPECT_EQ(within, 0.0) << cell;
    EXPECT_NEAR(below, 28.0, 28.0 * cell / 4 / 2.0) << cell;  // up to a row of samples
  }
}

TEST(Exposure, PointsOfWhatIsLeftLieInTheOpen) {
  const auto scene = roomWith({1.03F, 1.02F, -0.002F}, {2.21F, 1.87F, 0.8F});
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.2, &scene->caster);
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const vec3 p = texels.receivers.position(s);
    if (texels.area[s] <= 0.0F || texels.receivers.normal(s).z < 0.9F || p.z > 0.1F) continue;
    EXPECT_FALSE(p.x > 1.03F && p.x < 2.21F && p.y > 1.02F && p.y < 1.87F) << p.x << ' ' << p.y;
  }
}

TEST(Exposure, UnderATableThatHoversTheFloorStaysAndIsMarkedAsGap) {
  const auto scene = roomWith({1, 1, 0.01F}, {2, 2, 0.8F});
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  double below = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const vec3 p = texels.receivers.position(s);
    if (texels.area[s] <= 0.0F || texels.receivers.normal(s).z < 0.9F || p.z > 0.005F) continue;
    const bool under = p.x > 1.11F && p.x < 1.89F && p.y > 1.11F && p.y < 1.89F;
    const bool beside = p.x < 0.8F || p.x > 2.2F || p.y < 0.8F || p.y > 2.2F;
    if (under) {
      below += static_cast<double>(texels.area[s]);
      EXPECT_EQ(texels.openness[s], 0) << p.x << ' ' << p.y;
      EXPECT_GT(texels.gapReach(s), 0.01F);
    } else if (beside) {
      EXPECT_EQ(texels.openness[s], 2) << p.x << ' ' << p.y;
      EXPECT_EQ(texels.gapReach(s), 0.0F);
    }
  }
  EXPECT_GT(below, 0.5);  // of 0.61 m^2: nothing of it is matter
}

TEST(Exposure, FarAboveItIsNoGap) {
  const auto scene = roomWith({1, 1, 0.7F}, {2, 2, 0.75F});
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  EXPECT_NEAR(areaUp(texels, 0.0F), 12.0, 0.02);
  for (std::size_t s = 0; s < texels.slotCount(); ++s) EXPECT_GT(texels.openness[s], 0);
}

}  // namespace
}  // namespace soffit::transfer
