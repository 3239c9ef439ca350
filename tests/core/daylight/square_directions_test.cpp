// SPDX-License-Identifier: MIT
#include "core/daylight/square_directions.h"

#include <gtest/gtest.h>

namespace soffit::daylight {
namespace {

TEST(SquareDirections, WhatIsKeptIsWhatTheMapSays) {
  for (const int side : {16, 64, 128, 192, 512, 1024}) {
    const SquareDirections directions(side);
    for (int k = 0; k < 200; ++k) {
      const int column = k * 7919 % side;
      const int row = k * 104729 % side;
      // Divided: near the rim a rounding more is several in the direction.
      const auto n = static_cast<float>(side);
      const vec3 wanted = cosineHemisphere((static_cast<float>(column) + 0.5F) / n,
                                           (static_cast<float>(row) + 0.5F) / n);
      EXPECT_LT(glm::length(directions.at(column, row) - wanted), 1e-6F) << side;
    }
  }
}

}  // namespace
}  // namespace soffit::daylight
