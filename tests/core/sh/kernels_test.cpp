// SPDX-License-Identifier: MIT
#include "core/sh/kernels.h"

#include "core/sh/basis.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace soffit::sh {
namespace {

struct Directions {
  std::vector<float> x, y, z;
};

Directions split(const std::vector<dvec3>& directions, std::size_t n) {
  Directions d;
  for (std::size_t k = 0; k < n; ++k) {
    const vec3 f = glm::normalize(vec3(directions[k]));
    d.x.push_back(f.x);
    d.y.push_back(f.y);
    d.z.push_back(f.z);
  }
  return d;
}

TEST(EvaluateBatch, EqualsOneByOneForEveryCountAndNeverWritesBeyond) {
  const auto directions = testDirections(64, 5);
  for (const int bands : {1, 2, 5, 10}) {
    for (const std::size_t n : {0U, 1U, 3U, 15U, 16U, 17U, 31U, 64U}) {
      const Directions d = split(directions, n);
      const std::size_t stride = n + 3;
      std::vector<float> values(stride * coefficientCount(bands), -7.0F);
      evaluateBatch(d.x, d.y, d.z, bands, stride, values.data());
      std::vector<double> exact(coefficientCount(bands));
      for (std::size_t k = 0; k < stride; ++k) {
        if (k < n) evaluate(dvec3(d.x[k], d.y[k], d.z[k]), bands, exact);
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const float value = values[i * stride + k];
          if (k < n) {
            EXPECT_NEAR(value, exact[i], 7e-6);
          } else {
            EXPECT_EQ(value, -7.0F);
          }
        }
      }
    }
  }
}

TEST(SumOfProducts, EqualsTheSumInDouble) {
  Rng rng(6);
  for (const std::size_t n : {0U, 1U, 31U, 255U, 256U, 257U, 1000U}) {
    std::vector<float> row((n + kKernelBlock - 1) / kKernelBlock * kKernelBlock, 0.0F);
    std::array<std::vector<float>, 3> channels;
    std::array<double, 3> exact{}, size{};
    for (std::size_t k = 0; k < n; ++k) {
      row[k] = 2.0F * rng.uniform() - 1.0F;
      for (std::size_t c = 0; c < 3; ++c) {
        channels[c].push_back(rng.uniform());
        exact[c] += double(row[k]) * channels[c][k];
        size[c] += std::abs(double(row[k]) * channels[c][k]);
      }
    }
    const std::array<std::span<const float>, 3> spans{channels[0], channels[1], channels[2]};
    std::array<double, 3> sums{};
    sumOfProducts(row.data(), spans, sums.data());
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sums[c], exact[c], 1e-6 * size[c] + 1e-30);
    double one = 0.0;
    sumOfProducts(row.data(), std::span(spans).first(1), &one);
    EXPECT_EQ(one, sums[0]);
  }
}

TEST(DotBatch, EqualsTheDotProductOfEachReceiver) {
  Rng rng(7);
  for (const std::size_t n : {0U, 1U, 16U, 33U, 100U}) {
    const std::size_t stride = n + 5;
    std::vector<float> rows(25 * stride);
    for (float& v : rows) v = 2.0F * rng.uniform() - 1.0F;
    std::array<std::vector<float>, 3> light;
    for (auto& channel : light) {
      for (int i = 0; i < 25; ++i) channel.push_back(rng.uniform());
    }
    std::vector<float> r(n), g(n), b(n), one(n);
    dotBatch(light[0], light[1], light[2], rows.data(), stride, r, g, b);
    dotBatch(light[1], rows.data(), stride, one);
    for (std::size_t k = 0; k < n; ++k) {
      double exact[3] = {};
      for (std::size_t i = 0; i < 25; ++i) {
        for (std::size_t c = 0; c < 3; ++c) exact[c] += double(light[c][i]) * rows[i * stride + k];
      }
      // 25 products below 1: 25 eps of single precision.
      EXPECT_NEAR(r[k], exact[0], 25 * 6e-8);
      EXPECT_NEAR(g[k], exact[1], 25 * 6e-8);
      EXPECT_NEAR(b[k], exact[2], 25 * 6e-8);
      EXPECT_NEAR(one[k], exact[1], 25 * 6e-8);
    }
  }
}

}  // namespace
}  // namespace soffit::sh
