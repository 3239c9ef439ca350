// SPDX-License-Identifier: MIT
#include "core/design/sh_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace soffit::design {
namespace {

using testing::StartsWith;

TEST(ShBench, ClosedFormsHaveTheErrorsTheyState) {
  for (const ShBenchCase& c : shBenchCases(3)) {
    const double error = c.error();
    ASSERT_TRUE(std::isfinite(error)) << c.task << " " << c.method;
    EXPECT_GT(c.items, 0U);
    const bool sampled = c.task == "project" || c.method == "stratified on the light";
    // Single precision in the kernels, double elsewhere; what is sampled has a case of its own.
    const bool single = c.task == "evaluate" || c.task == "shade rgb" || c.task == "product";
    if (!sampled) {
      EXPECT_LT(error, single ? 2e-6 : 1e-11) << c.task << " " << c.method << " " << c.bands;
    }
  }
}

TEST(ShBench, SampledProjectionsConvergeInTheOrderOfTheirQuality) {
  std::map<std::string, double> error;  // at 5 bands and 100 x 100 samples
  for (const ShBenchCase& c : shBenchCases(3)) {
    if (c.task == "project" && c.bands == 5 && c.samples == 10000) error[c.method] = c.error();
  }
  ASSERT_EQ(error.size(), 3U);
  EXPECT_LT(error["stratified"], 0.5 * error["random"]);
  EXPECT_LT(error["hammersley"], 0.5 * error["random"]);
  EXPECT_LT(error["random"], 0.1);
}

TEST(ShBench, MeasuresEveryCaseAndStopsWhenAsked) {
  const auto rows = measureSh({.seed = 1, .seconds_per_case = 0.0}, {});
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->size(), shBenchCases(1).size());
  for (const ShBenchRow& row : *rows) EXPECT_GT(row.ns, 0.0);
  const std::string text = formatShBenchRows(*rows);
  EXPECT_THAT(text, StartsWith("task,method,bands,samples,ns,rms_error\nevaluate,recurrence,3,"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), rows->size() + 1);

  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measureSh({}, {nullptr, stop.get_token()}));
}

TEST(ShBench, RelativeErrorIsOfTheRootMeanSquares) {
  EXPECT_DOUBLE_EQ(relativeRms({3.0, 4.0}, {3.0, 3.0}), 1.0 / std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(relativeRms({3.0, 4.0}, {0.0, 0.0}), 5.0 / std::sqrt(2.0));
  EXPECT_EQ(relativeRms({}, {}), 0.0);
}

}  // namespace
}  // namespace soffit::design
