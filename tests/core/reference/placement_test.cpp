// SPDX-License-Identifier: MIT
#include "core/reference/placement.h"

#include "rooms.h"

#include <gtest/gtest.h>

namespace soffit::reference {
namespace {

dvec3 placed(const dvec3& position, const dvec3& normal) {
  const scene::Scene s =
      test::Builder().quad({0, 0, 1}, {2, 0, 0}, {0, 2, 0}, test::matte(0.5)).scene();
  return placeSensors(*s.mesh, std::vector<scene::Sensor>{{position, normal}})[0];
}

TEST(PlaceSensors, PutsASensorOnASurfaceToTheSideOfItsNormal) {
  for (const double off : {-0.9e-4, 0.0, 0.9e-4}) {
    EXPECT_GT(placed({0.7, 0.6, 1.0 + off}, {0, 0, 1}).z, 1.0) << off;
    EXPECT_LT(placed({0.7, 0.6, 1.0 + off}, {0, 0, -1}).z, 1.0) << off;
  }
}

TEST(PlaceSensors, KeepsTheSideOfASensorThatLooksAlongTheSurface) {
  EXPECT_GT(placed({0.7, 0.6, 1.00005}, {1, 0, 0}).z, 1.0);
  EXPECT_LT(placed({0.7, 0.6, 0.99995}, {1, 0, 0}).z, 1.0);
}

TEST(PlaceSensors, LeavesSensorsAlonePastTheLimitAndPastTheEdge) {
  EXPECT_EQ(placed({0.7, 0.6, 0.9998}, {0, 0, 1}), dvec3(0.7, 0.6, 0.9998));
  EXPECT_EQ(placed({-0.001, 0.6, 1.0}, {0, 0, -1}), dvec3(-0.001, 0.6, 1.0));
}

TEST(PlaceSensors, SubtractsTheMeshOrigin) {
  geometry::Mesh mesh;
  mesh.origin = {1000, 0, 0};
  const auto p = placeSensors(mesh, std::vector<scene::Sensor>{{{1001, 2, 3}, {0, 0, 1}}});
  EXPECT_EQ(p[0], dvec3(1, 2, 3));
}

}  // namespace
}  // namespace soffit::reference
