// SPDX-License-Identifier: MIT
#include "core/reference/sequence.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace soffit::reference {
namespace {

TEST(SobolPoint, PutsOnePointIntoEveryIntervalOfEachCoordinate) {
  constexpr std::uint32_t kCount = 256;
  for (const std::uint32_t seed : {0U, 1U, 0xdeadbeefU}) {
    std::array<std::vector<int>, 3> hits;
    for (auto& h : hits) h.assign(kCount, 0);
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const dvec3 u = sobolPoint(i, seed);
      for (int k = 0; k < 3; ++k) ++hits[k][static_cast<std::size_t>(u[k] * kCount)];
    }
    for (const auto& h : hits) EXPECT_EQ(h, std::vector<int>(kCount, 1)) << seed;
  }
}

TEST(SobolPoint, PutsOnePointIntoEveryElementaryRectangleOfItsFirstTwoCoordinates) {
  constexpr std::uint32_t kCount = 64;
  for (std::uint32_t columns = 1; columns <= kCount; columns *= 2) {
    const std::uint32_t rows = kCount / columns;
    std::vector<int> hits(kCount, 0);
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const dvec3 u = sobolPoint(i, 7);
      ++hits[static_cast<std::size_t>(u.x * columns) * rows + static_cast<std::size_t>(u.y * rows)];
    }
    EXPECT_EQ(hits, std::vector<int>(kCount, 1)) << columns << " columns";
  }
}

TEST(SobolPoint, EachPointIsUniformOverTheSeeds) {
  constexpr int kSeeds = 4096;
  for (const std::uint32_t i : {0U, 1U, 5U, 1023U}) {
    dvec3 sum(0.0);
    dvec3 squares(0.0);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      const dvec3 u = sobolPoint(i, seed);
      sum += u / double(kSeeds);
      squares += u * u / double(kSeeds);
    }
    // Statistical: 4.5 standard deviations of a mean of uniform numbers, and of their squares.
    const double spread = 4.5 * std::sqrt(1.0 / 12.0 / kSeeds);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(sum[k], 0.5, spread) << i;
      EXPECT_NEAR(squares[k], 1.0 / 3.0, spread * 1.04) << i;  // sqrt(4/45) / sqrt(1/12)
    }
  }
}

TEST(SobolPoint, SeedsAreUncorrelated) {
  constexpr std::uint32_t kCount = 4096;
  double product = 0.0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    product += (sobolPoint(i, 1).x - 0.5) * (sobolPoint(i, 2).x - 0.5) / kCount;
  }
  EXPECT_NEAR(product, 0.0, 4.5 / 12.0 / std::sqrt(double(kCount)));  // statistical, 4.5 sigma
}

}  // namespace
}  // namespace soffit::reference
