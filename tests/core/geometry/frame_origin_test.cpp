// SPDX-License-Identifier: MIT
#include "core/geometry/frame_origin.h"

#include <gtest/gtest.h>

namespace soffit::geometry {
namespace {

DoubleBox boxAt(const dvec3& center, double size) {
  DoubleBox box;
  box.add(center - 0.5 * size);
  box.add(center + 0.5 * size);
  return box;
}

TEST(FrameOrigin, EverydayModelsKeepTheWorldsZero) {
  EXPECT_EQ(chooseOrigin({}), dvec3(0.0));
  EXPECT_EQ(chooseOrigin(boxAt({0, 0, 0}, 10)), dvec3(0.0));
  EXPECT_EQ(chooseOrigin(boxAt({900, 0, 0}, 1)), dvec3(0.0));
  EXPECT_EQ(chooseOrigin(boxAt({5000, 0, 0}, 100)), dvec3(0.0));
  EXPECT_EQ(chooseOrigin(boxAt({0, 0, 0}, 50e3)), dvec3(0.0));
}

TEST(FrameOrigin, OutlyingModelsGetTheirCenterInWholeMetres) {
  EXPECT_EQ(chooseOrigin(boxAt({12000.4, -3.6, 0.2}, 500)), dvec3(12000, -4, 0));
  EXPECT_EQ(chooseOrigin(boxAt({0, 2000.7, 0}, 5)), dvec3(0, 2001, 0));
}

}  // namespace
}  // namespace soffit::geometry
