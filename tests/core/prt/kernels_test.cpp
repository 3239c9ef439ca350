// SPDX-License-Identifier: MIT
#include "core/prt/kernels.h"

#include "core/math/rng.h"
#include "core/prt/transfer_vectors.h"
#include "tests/core/transfer/every_target.h"

#include <gtest/gtest.h>

#include <vector>

namespace soffit::prt {
namespace {

TransferRows randomRows(std::size_t receivers, int bands, std::size_t channels) {
  Rng rng(receivers);
  TransferRows rows(receivers, bands, channels);
  for (std::size_t i = 0; i < receivers; ++i) {
    for (std::size_t c = 0; c < channels * rows.coefficients(); ++c) {
      rows.row(i)[c] = 2.0F * rng.uniform() - 1.0F;
    }
  }
  return rows;
}

TEST(PrtKernels, RowsAreAddedByWeight) {
  for (const int bands : {1, 3, 5, 7, 10}) {
    const TransferRows rows = randomRows(40, bands, 3);
    Rng rng(8);
    std::vector<Tap> taps;
    for (int k = 0; k < 30; ++k) taps.push_back({rng.below(40), rng.uniform()});
    std::vector<double> wanted(rows.stride(), 1.0);
    for (const Tap& tap : taps) {
      for (std::size_t c = 0; c < rows.stride(); ++c) {
        wanted[c] += double{tap.weight} * rows.row(tap.receiver)[c];
      }
    }
    transfer::testing::forEveryTarget([&] {
      std::vector<float> sum(rows.stride(), 1.0F);
      addRows(rows.data(), rows.stride(), taps, sum.data());
      // 30 terms below 1 in single precision.
      for (std::size_t c = 0; c < sum.size(); ++c) EXPECT_NEAR(sum[c], wanted[c], 30 * 6e-7);
    });
  }
}

TEST(PrtKernels, BlocksAreDotProductsOfHalves) {
  const TransferRows rows = randomRows(70, 5, 1);
  const TransferVectors vectors(rows);
  ASSERT_EQ(vectors.blockCount(), 3U);
  Rng rng(9);
  std::vector<float> light[3];
  for (auto& l : light) {
    for (int i = 0; i < 25; ++i) l.push_back(rng.uniform());
  }
  transfer::testing::forEveryTarget([&] {
    std::vector<float> out[3];
    for (auto& o : out) o.assign(96, -1.0F);
    dotBlocks(vectors.blocks().data(), vectors.blockStride(), 3, 25, 3,
              {{light[0].data(), light[1].data(), light[2].data()},
               {out[0].data(), out[1].data(), out[2].data()}});
    for (std::size_t k = 0; k < 70; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        double wanted = 0.0;
        for (std::size_t i = 0; i < 25; ++i) wanted += double{light[c][i]} * vectors.at(k, 0, i);
        EXPECT_NEAR(out[c][k], wanted, 25 * 6e-7);
      }
    }
    std::vector<float> one(96, -1.0F);
    dotBlocks(vectors.blocks().data(), vectors.blockStride(), 3, 25, 1,
              {{light[1].data(), nullptr, nullptr}, {one.data(), nullptr, nullptr}});
    EXPECT_EQ(one, out[1]);
  });
}

}  // namespace
}  // namespace soffit::prt
