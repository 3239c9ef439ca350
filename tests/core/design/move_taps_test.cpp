// SPDX-License-Identifier: MIT
#include "core/design/move_taps.h"

#include <gtest/gtest.h>

namespace soffit::design {
namespace {

TEST(MoveTaps, CountsEveryStage) {
  transfer::Operators operators;
  EXPECT_EQ(moveTaps(operators, 0), 0.0);
  operators.lists.entries.resize(10);
  operators.node_lists.entries.resize(20);
  operators.node_lists.constants.entries.resize(30);
  EXPECT_EQ(moveTaps(operators, 0), 60.0);
  operators.weights.resize(3);
  EXPECT_EQ(moveTaps(operators, 0), 62.0);
  operators.nodes.matrix.blocks.resize(2);
  EXPECT_EQ(moveTaps(operators, 0), 92.0);
  operators.texels.area.resize(4);  // a slot each
  EXPECT_EQ(moveTaps(operators, 0), 492.0);
  EXPECT_EQ(moveTaps(operators, 2), 516.0);  // lists and weights twice more
}

}  // namespace
}  // namespace soffit::design
