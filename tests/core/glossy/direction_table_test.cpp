// SPDX-License-Identifier: MIT
#include "core/glossy/direction_table.h"

#include "core/glossy/lobe_shape.h"
#include "core/glossy/transfer_matrix.h"
#include "core/sh/zonal.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

TEST(DirectionGrid, NodesAreTheirOwnTaps) {
  const DirectionGrid grid(8);
  EXPECT_EQ(grid.size(), 81U);
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const auto taps = grid.taps(grid.direction(k));
    dvec3 mean(0.0);
    for (std::size_t t = 0; t < 4; ++t) {
      mean += static_cast<double>(taps.weight[t]) * grid.direction(taps.node[t]);
    }
    EXPECT_NEAR(glm::length(mean - grid.direction(k)), 0.0, 1e-6);  // weights are float
  }
}

TEST(DirectionGrid, WeightsArePositiveAndSumToOneEverywhere) {
  Rng rng(1);
  const DirectionGrid grid(6);
  for (int k = 0; k < 1000; ++k) {
    const auto taps = grid.taps(randomDirection(rng));
    float sum = 0.0F;
    for (const float w : taps.weight) {
      EXPECT_GE(w, -1e-6F);
      sum += w;
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F);
  }
}

/// RMS difference from the matrix over random directions, as a share of the RMS value.
double interpolationError(int side, double alpha) {
  Rng rng(4);
  const DirectionGrid grid(side);
  const auto& kernel = lobeKernel(alpha);
  DirectionTable table(grid, 1, 5);
  const auto cap = sh::zonalAbout(sh::capKernel(0.9, 9), glm::normalize(dvec3(0.3, 0.2, 1.0)));
  const std::vector<double> matrix = matrixFromVisibility(cap, 5);
  table.set(0, matrix, kernel);
  double error = 0.0, size = 0.0;
  for (int k = 0; k < 200; ++k) {
    std::vector<float> light(25);
    for (float& x : light) x = 2.0F * rng.uniform() - 1.0F;
    std::vector<double> arriving(25, 0.0);
    for (std::size_t i = 0; i < 25; ++i) {
      for (std::size_t j = 0; j < 25; ++j) {
        arriving[i] += matrix[i * 25 + j] * static_cast<double>(light[j]);
      }
    }
    for (int d = 0; d < 20; ++d) {
      const dvec3 axis = randomDirection(rng);
      const double exact = glossyRadiance(arriving, kernel, axis);
      const double found = static_cast<double>(table.radiance(0, light, axis));
      error += (found - exact) * (found - exact);
      size += exact * exact;
    }
  }
  return std::sqrt(error / size);
}

TEST(DirectionTable, ErrorFallsWithTheSquareOfTheSpacing) {
  const double coarse = interpolationError(8, 0.4);
  const double fine = interpolationError(16, 0.4);
  EXPECT_GT(coarse / fine, 3.0);
  EXPECT_LT(coarse / fine, 5.0);
  EXPECT_LT(interpolationError(8, 0.7), coarse);
  EXPECT_LT(coarse, 0.12);
  EXPECT_LT(fine, 0.03);
}

TEST(DirectionTable, UnderAFixedLightNodesHoldTheRadiance) {
  const DirectionGrid grid(8);
  DirectionTable table(grid, 2, 3);
  const auto& kernel = lobeKernel(0.6);
  std::vector<double> identity(81, 0.0);
  for (std::size_t i = 0; i < 9; ++i) identity[i * 10] = 1.0;
  table.set(1, identity, kernel);
  const std::vector<float> light{1, 0.5F, -0.25F, 0.3F, 0.1F, 0, 0.2F, -0.4F, 0.6F};
  const std::vector<float> values = table.underLight(1, light);
  for (std::size_t k = 0; k < grid.size(); ++k) {
    EXPECT_NEAR(values[k], table.radiance(1, light, grid.direction(k)), 1e-5F);
  }
  for (const float v : table.underLight(0, light)) EXPECT_EQ(v, 0.0F);
  EXPECT_EQ(table.bytes(), 2U * 81U * 9U * 2U);
}

}  // namespace
}  // namespace soffit::glossy
