// SPDX-License-Identifier: MIT
#include "core/prt/skyline.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

namespace soffit::prt {
namespace {

TEST(Skyline, NothingOverlapsOrLeavesTheStrip) {
  Rng rng(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<glm::ivec2> sizes;
    double area = 0.0;
    const int count = 1 + static_cast<int>(rng.below(200));
    for (int i = 0; i < count; ++i) {
      sizes.emplace_back(1 + rng.below(30), 1 + rng.below(30));
      area += double(sizes.back().x) * sizes.back().y;
    }
    const int width = 30 + static_cast<int>(rng.below(200));
    const Packing packing = packRectangles(sizes, width);
    std::vector<int> owner(static_cast<std::size_t>(width * packing.height), -1);
    for (int k = 0; k < count; ++k) {
      const auto& place = packing.places[static_cast<std::size_t>(k)];
      const auto& size = sizes[static_cast<std::size_t>(k)];
      ASSERT_GE(place.x, 0);
      ASSERT_LE(place.x + size.x, width);
      ASSERT_LE(place.y + size.y, packing.height);
      for (int y = place.y; y < place.y + size.y; ++y) {
        for (int x = place.x; x < place.x + size.x; ++x) {
          int& o = owner[static_cast<std::size_t>(y * width + x)];
          ASSERT_EQ(o, -1);
          o = k;
        }
      }
    }
    // Many small ones leave little empty.
    EXPECT_GT(area, (count > 100 ? 0.75 : 0.0) * width * packing.height) << width;
  }
}

TEST(Skyline, OneFillsItsStrip) {
  const glm::ivec2 size(5, 3);
  const Packing packing = packRectangles({&size, 1}, 5);
  EXPECT_EQ(packing.height, 3);
  EXPECT_EQ(packing.places[0].x, 0);
  EXPECT_EQ(packRectangles({}, 5).height, 0);
}

}  // namespace
}  // namespace soffit::prt
