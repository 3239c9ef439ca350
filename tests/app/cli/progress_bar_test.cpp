// SPDX-License-Identifier: MIT
#include "app/cli/progress_bar.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace soffit::cli {
namespace {

TEST(ProgressLine, HasTheSameWidthThroughout) {
  for (const double done : {0.0, 0.5, 1.0, -1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(progressLine("tracing", done, 78).size(), 78U) << done;
  }
  EXPECT_EQ(progressLine(std::string(200, 'x'), 0.5, 78).size(), 78U);
  EXPECT_LE(progressLine("tracing", 0.5, 20).size(), 20U);
}

TEST(ProgressLine, SaysHowFarItIs) {
  EXPECT_NE(progressLine("tracing", 0.999, 78).find(" 99 %"), std::string::npos) << "not done yet";
  EXPECT_NE(progressLine("tracing", 1.0, 78).find("100 %"), std::string::npos);
}

}  // namespace
}  // namespace soffit::cli
