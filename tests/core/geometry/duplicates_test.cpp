// SPDX-License-Identifier: MIT
#include "core/geometry/duplicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/geometry/cleaning.h"
#include "core/geometry/components.h"
#include "core/geometry/shapes.h"

namespace soffit::geometry {
namespace {

// The triangles of a mesh over welded points.
std::vector<char> duplicatesIn(const Mesh& mesh) {
  const std::vector<std::uint32_t> point = findComponents(mesh).point_of;
  std::vector<uvec3> welded;
  for (const uvec3& t : mesh.triangles) welded.emplace_back(point[t.x], point[t.y], point[t.z]);
  return markDuplicates(mesh.positions, welded);
}

std::ptrdiff_t countDuplicates(const Mesh& mesh) {
  const std::vector<char> marks = duplicatesIn(mesh);
  return std::count(marks.begin(), marks.end(), char{1});
}

TEST(Duplicates, ARepeatedBoxGoesWhole) {
  const Mesh box = makeBox({0, 0, 0}, {1, 1, 1});
  const std::vector<char> marks = duplicatesIn(mergeMeshes({box, box, box}));
  for (std::size_t i = 0; i < marks.size(); ++i) EXPECT_EQ(marks[i], i < 12 ? 0 : 1);
}

TEST(Duplicates, TheBackOfASheetGoes) {
  const Mesh front = makeRectangle(1, 1);
  Mesh back = front;
  for (uvec3& t : back.triangles) std::swap(t.x, t.y);
  EXPECT_EQ(countDuplicates(mergeMeshes({front, back})), 2);
}

TEST(Duplicates, TouchingWallsOfTwoSolidsStay) {
  // The same points on both sides, so that the walls have the same diagonal: one box is the
  // other's mirror image.
  const Mesh left = makeBox({0, 0, 0}, {1, 1, 1});
  Mesh right = left;
  for (vec3& p : right.positions) p.x = 2.0F - p.x;
  for (uvec3& t : right.triangles) std::swap(t.x, t.y);
  const Mesh both = mergeMeshes({left, right});
  EXPECT_EQ(countDuplicates(both), 0);
  const Components parts = findComponents(both);
  ASSERT_EQ(parts.list.size(), 2U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_TRUE(parts.list[1].solid());
}

TEST(Duplicates, TouchingWallsOfOpenBoxesGo) {
  const Mesh left = makeBox({0, 0, 0}, {1, 1, 1});
  Mesh right = left;
  for (vec3& p : right.positions) p.x = 2.0F - p.x;
  for (uvec3& t : right.triangles) std::swap(t.x, t.y);
  right.triangles.pop_back();
  right.material_of.pop_back();
  right.object_of.pop_back();
  EXPECT_EQ(countDuplicates(mergeMeshes({left, right})), 2);
}

TEST(Duplicates, UnusedPointsMayBeAnything) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, nan, nan}};
  const std::vector<uvec3> triangles{{0, 1, 2}, {1, 0, 2}};
  const std::vector<char> expected{0, 1};
  EXPECT_EQ(markDuplicates(points, triangles), expected);
}

}  // namespace
}  // namespace soffit::geometry
