// SPDX-License-Identifier: MIT
#include "core/transfer/static_scene.h"

#include "core/geometry/shapes.h"
#include "core/transfer/charts.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

namespace soffit::transfer {
namespace {

/// A square ring about the z axis: 1 m outside, 0.9 m inside, from z = 0 to 0.05.
geometry::Mesh pictureFrame() {
  geometry::Mesh mesh;
  for (const float z : {0.0F, 0.05F}) {
    for (const float r : {0.5F, 0.45F}) {
      for (const vec2& c : {vec2(-r, -r), vec2(r, -r), vec2(r, r), vec2(-r, r)}) {
        mesh.positions.emplace_back(c.x, c.y, z);
      }
    }
  }
  // Rings of four corners: outer and inner at the back, outer and inner in front.
  const auto wall = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t next = (k + 1) % 4;
      mesh.triangles.emplace_back(from + k, from + next, to + next);
      mesh.triangles.emplace_back(from + k, to + next, to + k);
    }
  };
  wall(0, 8);
  wall(8, 12);
  wall(12, 4);
  wall(4, 0);
  return mesh;
}

std::vector<std::uint8_t> sidesOfObject(const StaticScene& scene, std::uint32_t object) {
  std::vector<std::uint8_t> sides;
  for (std::size_t t = 0; t < scene.sides.size(); ++t) {
    if (scene.mesh->object_of[t] == object) sides.push_back(scene.sides[t]);
  }
  return sides;
}

std::shared_ptr<const StaticScene> inRoom(const geometry::Mesh& shell,
                                          const geometry::Mesh& thing) {
  geometry::Mesh mesh;
  using testing::append;
  append(mesh, testing::roomBox({-2, -2, -1}, {2, 2, 2}), 0);
  append(mesh, shell, 1);
  append(mesh, thing, 2);
  mesh.object_of.clear();
  mesh.object_of.resize(12, 0);
  mesh.object_of.resize(12 + shell.triangles.size(), 1);
  mesh.object_of.resize(mesh.triangles.size(), 2);
  const std::vector<vec3> inside = {{1.5F, 1.5F, 1.5F}};
  return makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
}

TEST(StaticScene, AFrameIsNoRoomForThePictureThatDipsIntoIt) {
  const geometry::Mesh picture =
      geometry::makeBox({-0.458F, -0.458F, 0.01F}, {0.458F, 0.458F, 0.03F});
  for (const std::uint8_t side : sidesOfObject(*inRoom(pictureFrame(), picture), 1)) {
    EXPECT_EQ(side, kFront);
  }
}

TEST(StaticScene, AShellThatHoldsAThingIsLitInside) {
  const geometry::Mesh shell = geometry::makeBox({-0.5F, -0.5F, 0}, {0.5F, 0.5F, 1});
  const geometry::Mesh block = geometry::makeBox({-0.1F, -0.1F, 1e-3F}, {0.1F, 0.1F, 0.3F});
  for (const std::uint8_t side : sidesOfObject(*inRoom(shell, block), 1)) {
    EXPECT_EQ(side, kBothSides);
  }
}

}  // namespace
}  // namespace soffit::transfer
