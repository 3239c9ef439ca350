// SPDX-License-Identifier: MIT
#include "core/glossy/clustered_matrices.h"

#include "core/glossy/transfer_matrix.h"
#include "core/sh/zonal.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

/// Receivers whose sky is open within a cap of random axis and size: smooth in few parameters, as
/// neighbouring receivers of a building are.
std::vector<float> caps(std::size_t receivers, int bands) {
  Rng rng(21);
  std::vector<float> all;
  for (std::size_t r = 0; r < receivers; ++r) {
    const auto kernel = sh::capKernel(0.5 + 0.4 * rng.uniformDouble(), bands);
    const dvec3 axis =
        glm::normalize(dvec3(0.3 * rng.uniformDouble(), 0.3 * rng.uniformDouble(), 1));
    for (const double c : sh::zonalAbout(kernel, axis)) all.push_back(static_cast<float>(c));
  }
  return all;
}

sh::RgbCoefficients randomLight(std::size_t n, Rng& rng) {
  sh::RgbCoefficients light;
  for (auto& channel : light) {
    for (std::size_t i = 0; i < n; ++i) channel.push_back(2.0 * rng.uniformDouble() - 1.0);
  }
  return light;
}

TEST(MatrixNorms, AreTheSameForEveryOrder) {
  const std::vector<double> norms = matrixNorms(3);
  ASSERT_EQ(norms.size(), 5U);
  for (std::size_t k = 0; k < 25; ++k) {
    sh::Coefficients v(25, 0.0);
    v[k] = 1.0;
    double sum = 0.0;
    for (const double element : matrixFromVisibility(v, 3)) sum += element * element;
    EXPECT_NEAR(std::sqrt(sum), norms[static_cast<std::size_t>(sh::degreeOf(k))], 1e-12);
  }
  // v_00 = 1 is visibility 1 / (2 sqrt(pi)) all round: that times the identity of 9.
  EXPECT_NEAR(norms[0], 3.0 / (2.0 * std::sqrt(kPi)), 1e-12);
}

TEST(ClusteredMatrices, GiveWhatTheMatricesGiveWithinTheStatedError) {
  const int bands = 4;
  const std::size_t n = 16;
  const std::size_t m = 49;
  const std::size_t receivers = 300;
  const std::vector<float> visibility = caps(receivers, 2 * bands - 1);
  const ClusteredMatrices clustered(visibility, bands, {.clusters = 6, .rank = 6});
  Rng rng(5);
  double error = 0.0, size = 0.0;
  for (int trial = 0; trial < 20; ++trial) {
    const sh::RgbCoefficients light = randomLight(n, rng);
    FloatBlocks arriving(clustered.slots(), 3 * n);
    clustered.apply(light, arriving);
    for (std::size_t r = 0; r < receivers; ++r) {
      const sh::Coefficients v(visibility.begin() + static_cast<std::ptrdiff_t>(r * m),
                               visibility.begin() + static_cast<std::ptrdiff_t>((r + 1) * m));
      const std::vector<double> matrix = matrixFromVisibility(v, bands);
      for (std::size_t k = 0; k < 3 * n; ++k) {
        double exact = 0.0;
        for (std::size_t j = 0; j < n; ++j) exact += matrix[k % n * n + j] * light[k / n][j];
        const double found = static_cast<double>(arriving.at(clustered.slotOf(r), k));
        error += (found - exact) * (found - exact);
        size += exact * exact;
      }
    }
  }
  const double measured = std::sqrt(error / size);
  // Statistical: 60 random lights; and binary16.
  EXPECT_NEAR(measured, clustered.measuredError(), 0.2 * clustered.measuredError() + 0x1p-11);
  EXPECT_NEAR(clustered.predictedError(6), clustered.measuredError(),
              0.05 * clustered.measuredError() + 0x1p-11);
  EXPECT_LT(clustered.measuredError(), 0.01);
}

TEST(ClusteredMatrices, EveryReceiverHasItsOwnSlot) {
  const std::vector<float> visibility = caps(50, 5);
  const ClusteredMatrices clustered(visibility, 3, {.clusters = 7, .rank = 2});
  std::vector<int> used(clustered.slots(), 0);
  for (std::size_t r = 0; r < 50; ++r) used[clustered.slotOf(r)] += 1;
  for (const int count : used) EXPECT_LE(count, 1);
  const ClusteredMatrices none({}, 3, {.clusters = 7, .rank = 2});
  EXPECT_EQ(none.slots(), 0U);
}

}  // namespace
}  // namespace soffit::glossy
