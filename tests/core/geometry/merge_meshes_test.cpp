// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/cleaning.h"
#include "core/geometry/shapes.h"

namespace soffit::geometry {
namespace {

TEST(MergeMeshes, JoinsMaterialsByNameAndKeepsObjects) {
  Mesh box = makeBox({0, 0, 0}, {1, 1, 1});
  Mesh disk = makeDisk(1, 3);
  box.materials = {"oak"};
  disk.materials = {"steel", "oak"};
  disk.material_of = {0, 1, 1};
  disk.uvs.assign(disk.positions.size(), vec2(0.5F));
  const Mesh both = mergeMeshes({box, disk});
  EXPECT_EQ(both.materials, (std::vector<std::string>{"oak", "steel"}));
  EXPECT_EQ(both.objects, (std::vector<std::string>{"box", "disk"}));
  ASSERT_EQ(both.triangles.size(), 15U);
  EXPECT_EQ(both.material_of[12], 1U);
  EXPECT_EQ(both.material_of[13], 0U);
  EXPECT_EQ(both.object_of[12], 1U);
  EXPECT_EQ(both.uvs.size(), both.positions.size());
  EXPECT_EQ(both.positions[both.triangles[12].y], disk.positions[disk.triangles[0].y]);
}

TEST(MergeMeshes, BringsDifferentOriginsTogether) {
  Mesh near = makeBox({0, 0, 0}, {1, 1, 1});
  Mesh far = near;
  near.origin = {400000, 5000000, 0};
  far.origin = {400010, 5000000, 0};
  const Mesh both = mergeMeshes({near, far});
  EXPECT_EQ(both.origin, dvec3(400006, 5000001, 1));  // the center in whole metres
  for (std::size_t i = 0; i < near.positions.size(); ++i) {
    // Whole metres: exact.
    EXPECT_EQ(both.origin + dvec3(both.positions[i]), near.origin + dvec3(near.positions[i]));
    EXPECT_EQ(both.positions[i + near.positions.size()] - both.positions[i], vec3(10, 0, 0));
  }
}

TEST(MergeMeshes, OfNothingIsEmpty) {
  EXPECT_TRUE(mergeMeshes({}).triangles.empty());
}

}  // namespace
}  // namespace soffit::geometry
