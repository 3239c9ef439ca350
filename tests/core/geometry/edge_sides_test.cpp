// SPDX-License-Identifier: MIT
#include "core/geometry/edge_sides.h"

#include <gtest/gtest.h>

namespace soffit::geometry {
namespace {

TEST(EdgeSides, GathersTheTrianglesOfEveryEdge) {
  // Two triangles of a quad over the edge 0-2, and one without area that has no sides.
  const std::vector<uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 4, 1}};
  const std::vector<EdgeSide> sides = sortedEdgeSides(triangles);
  EXPECT_EQ(sides.size(), 6U);
  int edges = 0;
  int shared = 0;
  forEachEdge(sides, [&](std::span<const EdgeSide> edge) {
    ++edges;
    if (edge.size() == 1) return;
    ++shared;
    ASSERT_EQ(edge.size(), 2U);
    EXPECT_EQ(edge[0].lo, 0U);
    EXPECT_EQ(edge[0].hi, 2U);
    EXPECT_EQ(edge[0].triangle, 0U);
    EXPECT_FALSE(edge[0].forward);
    EXPECT_EQ(edge[0].apex, 1U);
    EXPECT_EQ(edge[1].triangle, 1U);
    EXPECT_TRUE(edge[1].forward);
    EXPECT_EQ(edge[1].apex, 3U);
  });
  EXPECT_EQ(edges, 5);
  EXPECT_EQ(shared, 1);
}

TEST(EdgeSides, NothingHasNoEdges) {
  forEachEdge(sortedEdgeSides({}), [](std::span<const EdgeSide>) { FAIL(); });
}

}  // namespace
}  // namespace soffit::geometry
