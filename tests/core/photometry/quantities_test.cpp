// SPDX-License-Identifier: MIT
#include "core/photometry/quantities.h"

#include <gtest/gtest.h>

namespace soffit::photometry {
namespace {

static_assert(pointIlluminance({.cd = 100.0}, 2.0, 1.0).lx == 25.0);  // inverse square
static_assert(pointIlluminance({.cd = 100.0}, 1.0, 0.5).lx == 50.0);

TEST(Quantities, APointBehindTheReceiverGivesNothing) {
  EXPECT_EQ(pointIlluminance({.cd = 100.0}, 1.0, -0.3).lx, 0.0);
}

}  // namespace
}  // namespace soffit::photometry
