// SPDX-License-Identifier: MIT
#include "core/geometry/plan_mask.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soffit::geometry {
namespace {

/// Rows from j = 0 on, '#' is inside.
PlanMask maskOf(const std::vector<std::string>& rows) {
  PlanMask mask{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows) {
    for (const char c : row) mask.inside.push_back(c == '#' ? 1 : 0);
  }
  return mask;
}

TEST(LargestRectangle, OfAnLIsItsLargerLeg) {
  const CellRectangle found =
      largestRectangle(maskOf({"#####", "#####", "##...", "##...", "##..."}));
  EXPECT_EQ(found.area(), 10);
  const CellRectangle tall =
      largestRectangle(maskOf({"####.", "##...", "##...", "##...", "##..."}));
  EXPECT_EQ(tall.lo, glm::ivec2(0, 0));
  EXPECT_EQ(tall.hi, glm::ivec2(2, 5));
}

TEST(LargestRectangle, OfNothingIsEmpty) {
  EXPECT_EQ(largestRectangle(maskOf({"...", "..."})).area(), 0);
}

TEST(LargestRectangle, HasNoHole) {
  const PlanMask mask = maskOf({"######", "######", "##.###", "######"});
  const CellRectangle found = largestRectangle(mask);
  EXPECT_EQ(found.area(), 12);
  for (int j = found.lo.y; j < found.hi.y; ++j) {
    for (int i = found.lo.x; i < found.hi.x; ++i) EXPECT_TRUE(mask.at(i, j));
  }
}

TEST(StepsInside, AreTheChessboardDistance) {
  const auto steps = stepsInside(maskOf({"#####", "#####", "#####", "#####", "#####"}));
  EXPECT_EQ(steps, (std::vector<int>{1, 1, 1, 1, 1,  //
                                     1, 2, 2, 2, 1,  //
                                     1, 2, 3, 2, 1,  //
                                     1, 2, 2, 2, 1,  //
                                     1, 1, 1, 1, 1}));
  EXPECT_EQ(stepsInside(maskOf({".#.", "###"})), (std::vector<int>{0, 1, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace soffit::geometry
