// SPDX-License-Identifier: MIT
#include "core/prt/surfaces.h"

#include "core/prt/material_maps.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;
using transfer::kBack;
using transfer::kBothSides;
using transfer::kFront;
using transfer::kNoSide;

TEST(Surfaces, SidesFollowWhatIsAClosedThing) {
  const auto box = geometry::makeBox({0, 0, 0}, {4, 4, 3});
  geometry::Mesh inward = box;
  for (uvec3& t : inward.triangles) std::swap(t.y, t.z);
  EXPECT_EQ(Builder().add(box, matte(vec3(0.5F))).surfaces()->sides[0], kFront);
  EXPECT_EQ(Builder().add(box, matte(vec3(0.5F))).surfaces({vec3(1, 1, 1)})->sides[0], kBack);
  EXPECT_EQ(Builder().add(inward, matte(vec3(0.5F))).surfaces()->sides[0], kBack);
  EXPECT_EQ(Builder().add(inward, matte(vec3(0.5F))).surfaces({vec3(1, 1, 1)})->sides[0], kFront);
  // A box that holds another is a room; what stands in it is a thing.
  Builder room;
  room.add(box, matte(vec3(0.5F)));
  room.add(geometry::makeBox({1, 1, 0.5F}, {2, 2, 1}), matte(vec3(0.5F)));
  EXPECT_EQ(room.surfaces()->sides[0], kBack);
  EXPECT_EQ(room.surfaces()->sides[12], kFront);
  EXPECT_EQ(Builder().add(geometry::makeRectangle(1, 1), matte(vec3(0.5F))).surfaces()->sides[0],
            kBothSides);
}

TEST(Surfaces, GlassReceivesNothingAndStandsInNoRaysWay) {
  scene::Material glass;
  glass.glass = scene::Glass{};
  const auto surfaces = Builder().add(geometry::makeRectangle(1, 1), glass).surfaces();
  EXPECT_EQ(surfaces->sides[0], kNoSide);
  EXPECT_FALSE(surfaces->caster->occluded({{0.1F, 0.2F, 1}, 0.0F, {0, 0, -1}}));
}

TEST(Surfaces, CornerNormalsLieOnTheFrontsSide) {
  geometry::Mesh quad = testing::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  quad.normals[0] = {0, 0, -2};
  quad.normals[1] = {0, 0, 0};
  const auto surfaces = Builder().add(quad, matte(vec3(0.5F))).surfaces();
  for (const vec3& n : surfaces->corner_normals) EXPECT_EQ(n, vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(surfaces->areas[0], 0.5F);
}

TEST(MaterialMaps, MeansOverWidthsAndRepeats) {
  scene::Image image;
  image.width = 4;
  image.height = 1;
  image.pixels = {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1};
  EXPECT_FLOAT_EQ(meanOf(image, {0.375F, 0.5F}, vec2(0.0F)).x, 1.0F);
  EXPECT_FLOAT_EQ(meanOf(image, {0.625F, 0.5F}, vec2(0.0F)).x, 0.0F);
  EXPECT_FLOAT_EQ(meanOf(image, {1.375F, -3.5F}, vec2(0.0F)).x, 1.0F);
  EXPECT_NEAR(meanOf(image, {0.375F, 0.5F}, vec2(1.0F, 1.0F)).x, 0.5F, 1e-6F);
  EXPECT_FLOAT_EQ(meanOf(image, vec2(std::nanf("")), vec2(0.0F)).x, 0.5F);
}

}  // namespace
}  // namespace soffit::prt
