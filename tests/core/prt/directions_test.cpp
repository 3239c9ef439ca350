// SPDX-License-Identifier: MIT
#include "core/prt/directions.h"

#include "core/sh/basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::prt {
namespace {

TEST(Directions, TheTableIsWeightTimesBasis) {
  for (const int bands : {1, 4, 10}) {
    const Directions directions(sh::cubature(9), bands);
    EXPECT_EQ(directions.rowStride() % 16, 0U);
    double sum = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      std::array<double, sh::kMaxCoefficients> basis;
      sh::evaluate(dvec3(directions[i]), bands, basis);
      const float* row = directions.table() + i * directions.rowStride();
      for (std::size_t c = 0; c < directions.rowStride(); ++c) {
        const double wanted =
            c < directions.coefficients() ? basis[c] * double{directions.weight(i)} : 0.0;
        EXPECT_NEAR(row[c], wanted, 2e-6);
      }
      sum += double{directions.weight(i)};
    }
    EXPECT_NEAR(sum, 4 * kPi, 1e-5);
  }
}

TEST(Directions, NeighborsLookTheSameWay) {
  const sh::SphereSamples samples = sh::hammersleySamples(1024);
  const Directions directions(samples, 2);
  ASSERT_EQ(directions.size(), samples.size());
  const auto turn = [](const dvec3& a, const dvec3& b) {
    return std::acos(std::min(1.0, glm::dot(a, b)));
  };
  double sorted = 0.0, given = 0.0;
  vec3 all(0.0F);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    all += directions[i];
    if (i == 0) continue;
    sorted += turn(dvec3(directions[i - 1]), dvec3(directions[i]));
    given += turn(samples.directions[i - 1], samples.directions[i]);
  }
  EXPECT_LT(sorted, 0.2 * given);
  dvec3 wanted(0.0);
  for (const dvec3& d : samples.directions) wanted += d;
  EXPECT_LT(glm::length(dvec3(all) - wanted), 1e-3);
}

}  // namespace
}  // namespace soffit::prt
