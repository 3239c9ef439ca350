// SPDX-License-Identifier: MIT
#include "core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/components.h"

namespace soffit::geometry {
namespace {

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]);
    sum += 0.5 *
           glm::length(glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a));
  }
  return sum;
}

// Shading normals agree with the winding to within the angle between neighboring facets.
void expectNormalsOnTheFront(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const uvec3& t : mesh.triangles) {
    const vec3 a = mesh.positions[t.x];
    const vec3 face = glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
    for (int k = 0; k < 3; ++k) EXPECT_GT(glm::dot(face, mesh.normals[t[k]]), 0.5F);
  }
}

// Round-off: coordinates are stored to 2^-24, areas and volumes are sums of products of them.
constexpr double kRoundoff = 64 * 0x1p-24;

TEST(Shapes, BoxHasItsVolumeAndArea) {
  const Mesh box = makeBox({1, 2, 3}, {3, 5, 7});
  const Components parts = findComponents(box);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_NEAR(parts.list[0].signed_volume, 24.0, 24.0 * kRoundoff);
  EXPECT_NEAR(area(box), 2.0 * (6.0 + 8.0 + 12.0), 52.0 * kRoundoff);
  expectNormalsOnTheFront(box);
}

TEST(Shapes, SphereConvergesWithTheSquareOfItsBands) {
  for (const int bands : {8, 16, 32}) {
    const Mesh sphere = makeSphere({1, -1, 2}, 0.5F, bands);
    const Components parts = findComponents(sphere);
    ASSERT_EQ(parts.list.size(), 1U);
    EXPECT_TRUE(parts.list[0].solid());
    const double exact = 4.0 / 3.0 * kPi * 0.125;
    const double shortfall = 1.0 - parts.list[0].signed_volume / exact;
    // Truncation: second order as documented, the next term is of relative size 1 / bands^2.
    EXPECT_NEAR(shortfall * bands * bands, 5.0 * kPi * kPi / 12.0, 10.0 / (bands * bands));
    expectNormalsOnTheFront(sphere);
  }
}

TEST(Shapes, TubeIsClosedOnlyIfAsked) {
  for (const bool closed : {false, true}) {
    const Mesh tube = makeTube(1.2F, 0.02F, 12, closed);
    const Components parts = findComponents(tube);
    ASSERT_EQ(parts.list.size(), 1U);
    EXPECT_EQ(parts.list[0].closed, closed);
    EXPECT_TRUE(parts.list[0].consistent);
    const double polygon = 12 * 0.5 * 0.02 * 0.02 * std::sin(2 * kPi / 12);
    if (closed) {
      EXPECT_NEAR(parts.list[0].signed_volume / (1.2 * polygon), 1.0, kRoundoff);
    }
    expectNormalsOnTheFront(tube);
  }
}

TEST(Shapes, SheetsFaceUp) {
  const Mesh disk = makeDisk(2.0F, 6);
  EXPECT_NEAR(area(disk), 6 * std::sqrt(3.0), 11 * kRoundoff);
  expectNormalsOnTheFront(disk);
  const Mesh rectangle = makeRectangle(2.0F, 3.0F, 4, 5);
  EXPECT_EQ(rectangle.triangles.size(), 40U);
  EXPECT_NEAR(area(rectangle), 6.0, 6 * kRoundoff);
  expectNormalsOnTheFront(rectangle);
}

}  // namespace
}  // namespace soffit::geometry
