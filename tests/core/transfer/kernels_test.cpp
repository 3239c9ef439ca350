// SPDX-License-Identifier: MIT
// The loops against plain ones, with lengths that no vector unit divides.
#include "core/transfer/kernels.h"

#include "core/math/rng.h"
#include "tests/core/transfer/every_target.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace soffit::transfer {
namespace {

using testing::forEveryTarget;

std::vector<float> randoms(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<float> v(n);
  for (float& x : v) x = 2.0F * rng.uniform() - 1.0F;
  return v;
}

TEST(Interpolate, AddsTheWeightedSums) {
  for (const std::size_t slots : {16U, 48U, 256U}) {
    for (const std::size_t rank : {0U, 1U, 2U, 3U, 7U, 48U}) {
      const std::vector<float> wished = randoms(rank * slots, 3);
      std::vector<Half> weights(wished.begin(), wished.end());
      // Zeros, the smallest and steps below the normal ones are numbers like others.
      for (std::size_t k = 0; k < weights.size(); ++k) {
        if (k % 5 == 0) weights[k].bits = static_cast<std::uint16_t>(k % 0x400U | k % 2 << 15U);
      }
      std::vector<vec4> y(rank);
      Rng rng(4);
      for (vec4& v : y) v = {rng.uniform(), rng.uniform(), rng.uniform(), 0};
      const std::array<std::vector<float>, 3> before = {randoms(slots, 5), randoms(slots, 6),
                                                        randoms(slots, 7)};
      forEveryTarget([&] {
        auto out = before;
        interpolate(weights, y, slots, out[0].data(), out[1].data(), out[2].data());
        for (std::size_t c = 0; c < 3; ++c) {
          for (std::size_t s = 0; s < slots; ++s) {
            double expected = static_cast<double>(before[c][s]);
            for (std::size_t k = 0; k < rank; ++k) {
              expected += static_cast<double>(static_cast<float>(weights[k * slots + s])) *
                          static_cast<double>(y[k][static_cast<int>(c)]);
            }
            EXPECT_NEAR(static_cast<double>(out[c][s]), expected,
                        1e-5);  // round-off of 48 products
          }
        }
      });
    }
  }
}

TEST(Interpolate, KeepsTheSmallestHalves) {
  std::vector<Half> weights(1024);
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k].bits = static_cast<std::uint16_t>(k);
  const std::vector<vec4> y(1, vec4(1.0F));
  forEveryTarget([&] {
    std::array<std::vector<float>, 3> out;
    for (auto& plane : out) plane.assign(weights.size(), 0.0F);
    interpolate(weights, y, weights.size(), out[0].data(), out[1].data(), out[2].data());
    for (std::size_t k = 0; k < weights.size(); ++k) {
      EXPECT_EQ(out[1][k], static_cast<float>(weights[k])) << k;
    }
  });
}

TEST(AddScaled, WorksForAnyLength) {
  for (std::size_t n = 0; n < 70; ++n) {
    const std::vector<float> x = randoms(n + 3, 8);
    std::vector<float> y = randoms(n + 3, 9);
    const std::vector<float> before = y;
    addScaled(0.3F, x.data(), y.data(), n);
    for (std::size_t i = 0; i < n + 3; ++i) {
      const double expected =
          static_cast<double>(before[i]) + (i < n ? 0.3F * static_cast<double>(x[i]) : 0.0);
      EXPECT_NEAR(static_cast<double>(y[i]), expected, 2e-7) << n << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace soffit::transfer
