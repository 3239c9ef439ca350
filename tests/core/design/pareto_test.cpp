// SPDX-License-Identifier: MIT
#include "core/design/pareto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace soffit::design {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ParetoFront, KeepsWhatNothingBeats) {
  const std::vector<Tradeoff> choices{{3, 1}, {1, 3}, {2, 3}, {2, 2}, {4, 1}, {5, 0.5}};
  EXPECT_THAT(paretoFront(choices), ElementsAre(1, 3, 0, 5));
}

TEST(ParetoFront, TakesTheFirstOfEquals) {
  const std::vector<Tradeoff> choices{{1, 1}, {1, 1}};
  EXPECT_THAT(paretoFront(choices), ElementsAre(0));
}

TEST(ParetoFront, LeavesOutWhatIsNotANumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Tradeoff> choices{{kNan, 0}, {0, kNan}, {1, 1}};
  EXPECT_THAT(paretoFront(choices), ElementsAre(2));
  EXPECT_THAT(paretoFront({}), IsEmpty());
}

}  // namespace
}  // namespace soffit::design
