// SPDX-License-Identifier: MIT
#include "core/glossy/cpca.h"

#include "core/glossy/components.h"
#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace soffit::glossy {
namespace {

constexpr std::size_t kDimension = 40;

std::vector<float> randomRow(Rng& rng) {
  std::vector<float> row(kDimension);
  for (float& x : row) x = 2.0F * rng.uniform() - 1.0F;
  return row;
}

/// Clusters of affine subspaces of 2 dimensions, far apart.
std::vector<float> planes(std::size_t clusters, std::size_t members, Rng& rng) {
  std::vector<float> all;
  for (std::size_t c = 0; c < clusters; ++c) {
    const auto base = randomRow(rng);
    const auto a = randomRow(rng);
    const auto b = randomRow(rng);
    for (std::size_t k = 0; k < members; ++k) {
      const float s = rng.uniform() - 0.5F;
      const float t = rng.uniform() - 0.5F;
      for (std::size_t i = 0; i < kDimension; ++i) {
        all.push_back(10.0F * base[i] + s * a[i] + t * b[i]);
      }
    }
  }
  return all;
}

TEST(Components, FindTheAxesOfAnEllipsoid) {
  // Members on the coordinate axes, at +-(dimension - i): variances 2 (dimension - i)^2.
  std::vector<float> vectors;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const float sign : {1.0F, -1.0F}) {
      std::vector<float> row(6, 2.0F);
      row[i] += sign * std::pow(2.0F, 6.0F - static_cast<float>(i));
      vectors.insert(vectors.end(), row.begin(), row.end());
    }
  }
  std::vector<std::uint32_t> members(12);
  std::iota(members.begin(), members.end(), 0U);
  const Components found = principalComponents(vectors, 6, members, 2);
  ASSERT_EQ(found.variances.size(), 2U);
  EXPECT_NEAR(found.variances[0], 2.0 * 64.0 * 64.0, 1e-2);  // single precision sums
  EXPECT_NEAR(found.variances[1], 2.0 * 32.0 * 32.0, 1e-2);
  EXPECT_NEAR(std::abs(found.rows[0]), 1.0F, 1e-5F);
  EXPECT_NEAR(std::abs(found.rows[6 + 1]), 1.0F, 1e-5F);
  for (const float m : found.mean) EXPECT_FLOAT_EQ(m, 2.0F);
  EXPECT_NEAR(found.total, 2.0 * (4096 + 1024 + 256 + 64 + 16 + 4), 1e-2);
}

TEST(Components, OfOneOrOfEqualVectorsIsTheMeanAlone) {
  const std::vector<float> vectors(3 * kDimension, 0.25F);
  const std::vector<std::uint32_t> all{0, 1, 2};
  const Components found = principalComponents(vectors, kDimension, all, 4);
  EXPECT_TRUE(found.variances.empty());
  EXPECT_EQ(found.total, 0.0);
}

TEST(Cpca, PlanesAreFoundExactly) {
  Rng rng(7);
  const std::vector<float> vectors = planes(5, 60, rng);
  const Cpca cpca(vectors, kDimension, {.clusters = 5, .rank = 2});
  // Coefficients are rounded to 2^-11; they are small against the vectors.
  EXPECT_LT(cpca.measuredError(vectors), 0x1p-11);
  EXPECT_LT(cpca.predictedError(2), 1e-5);
  EXPECT_GT(cpca.predictedError(1), 1e-3);
}

TEST(Cpca, PredictionIsTheMeasurement) {
  Rng rng(8);
  std::vector<float> vectors = planes(4, 100, rng);
  for (float& x : vectors) x += 0.5F * (rng.uniform() - 0.5F);
  const Cpca cpca(vectors, kDimension, {.clusters = 4, .rank = 5});
  EXPECT_NEAR(cpca.measuredError(vectors), cpca.predictedError(5),
              0.01 * cpca.predictedError(5) + 0x1p-11);
  for (std::size_t rank = 1; rank <= 5; ++rank) {
    EXPECT_LE(cpca.predictedError(rank), cpca.predictedError(rank - 1));
  }
  // Components truncated to a lower rank are those of a fit at that rank on the same clusters.
  const Cpca low(vectors, kDimension, {.clusters = 4, .rank = 2, .rounds = 0});
  const Cpca high(vectors, kDimension, {.clusters = 4, .rank = 5, .rounds = 0});
  EXPECT_NEAR(low.predictedError(2), high.predictedError(2), 0.02 * high.predictedError(2));
}

TEST(Cpca, MoreClustersOrRoundsAreNotWorse) {
  Rng rng(9);
  std::vector<float> vectors = planes(12, 50, rng);
  for (float& x : vectors) x += 0.3F * (rng.uniform() - 0.5F);
  const auto error = [&](int clusters, int rank, int rounds) {
    return Cpca(vectors, kDimension, {.clusters = clusters, .rank = rank, .rounds = rounds})
        .predictedError(static_cast<std::size_t>(rank));
  };
  EXPECT_LT(error(12, 2, 4), error(3, 2, 4));
  EXPECT_LT(error(6, 4, 4), error(6, 1, 4));
  EXPECT_LE(error(6, 2, 4), error(6, 2, 0) * 1.0001);
}

TEST(Cpca, DegenerateInputs) {
  const Cpca none({}, kDimension, {.clusters = 3, .rank = 2});
  EXPECT_EQ(none.count(), 0U);
  const std::vector<float> one(kDimension, 0.5F);
  const Cpca single(one, kDimension, {.clusters = 3, .rank = 2});
  EXPECT_EQ(single.measuredError(one), 0.0);
  const std::vector<float> zeros(10 * kDimension, 0.0F);
  EXPECT_EQ(Cpca(zeros, kDimension, {.clusters = 3, .rank = 2}).measuredError(zeros), 0.0);
}

}  // namespace
}  // namespace soffit::glossy
