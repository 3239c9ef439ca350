// SPDX-License-Identifier: MIT
#include "core/geometry/triangle_area.h"

#include "core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace soffit::geometry {
namespace {

TEST(TriangleArea, IsHalfTheProductOfTheLegs) {
  Mesh mesh;
  mesh.positions = {{1, 2, 3}, {4, 2, 3}, {1, 2, 7}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 0}, {0, 1, 1}};
  EXPECT_EQ(areaOf(mesh, 0), 6.0);
  EXPECT_EQ(areaOf(mesh, 1), 6.0) << "whatever the winding";
  EXPECT_EQ(areaOf(mesh, 2), 0.0) << "two corners in one place";
}

TEST(TriangleArea, AddsUpToTheSurface) {
  const Mesh box = makeBox({0, 0, 0}, {2, 3, 5});
  double sum = 0.0;
  for (std::size_t t = 0; t < box.triangles.size(); ++t) sum += areaOf(box, t);
  // Whole numbers: only the square root rounds.
  EXPECT_NEAR(sum, 62.0, 62.0 * std::numeric_limits<float>::epsilon());
}

}  // namespace
}  // namespace soffit::geometry
