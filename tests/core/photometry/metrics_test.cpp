// SPDX-License-Identifier: MIT
#include "core/photometry/metrics.h"

#include <gtest/gtest.h>

#include <vector>

namespace soffit::photometry {
namespace {

TEST(Metrics, UniformityIsMinimumOverMeanAndDiversityMinimumOverMaximum) {
  const std::vector<double> lux{200, 400, 300, 700};
  const FieldMetrics m = fieldMetrics(lux);
  EXPECT_EQ(m.count, 4u);
  EXPECT_EQ(m.mean, 400.0);
  EXPECT_EQ(m.min, 200.0);
  EXPECT_EQ(m.max, 700.0);
  EXPECT_EQ(m.u0, 0.5);
  EXPECT_EQ(m.ud, 200.0 / 700.0);
}

TEST(Metrics, DarkAndEmptyFieldsDoNotDivideByZero) {
  EXPECT_EQ(fieldMetrics({}).count, 0u);
  const std::vector<double> dark{0.0, 0.0};
  EXPECT_EQ(fieldMetrics(dark).u0, 0.0);
  EXPECT_EQ(fieldMetrics(dark).ud, 0.0);
}

TEST(Metrics, PercentilesAreLinearBetweenOrderStatistics) {
  const std::vector<double> v{4, 1, 3, 2, 5};
  EXPECT_EQ(percentile(v, 0.0), 1.0);
  EXPECT_EQ(percentile(v, 0.5), 3.0);
  EXPECT_EQ(percentile(v, 0.625), 3.5);
  EXPECT_EQ(percentile(v, 1.0), 5.0);
  EXPECT_EQ(percentile(v, 7.0), 5.0);
  EXPECT_EQ(percentile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace soffit::photometry
