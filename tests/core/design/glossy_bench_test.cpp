// SPDX-License-Identifier: MIT
#include "core/design/glossy_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace soffit::design {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t kReceivers = 300;

TEST(GlossyBench, MethodsHaveTheErrorsTheyState) {
  std::map<std::string, double> error;
  std::map<std::string, std::size_t> bytes;
  for (const GlossyBenchCase& c : glossyBenchCases(kReceivers, 3)) {
    c.run();
    error[c.method] = c.error();
    bytes[c.method] = c.bytes;
    EXPECT_TRUE(std::isfinite(c.error())) << c.method;
    EXPECT_GT(c.items, 0U);
  }
  // Halves: 2^-11 an element.
  EXPECT_LT(error["25 x 25, all elements"], 0x1p-11);
  EXPECT_LT(error["25 x 25, upper triangle"], 0x1p-11);
  EXPECT_LT(error["fixed light, 81 of visibility"], 0x1p-10);
  EXPECT_LT(error["lobe per receiver"], 1e-5);
  // As many coefficients of visibility as of light lose what is above; both forms alike.
  EXPECT_GT(error["fixed light, 25 of visibility"], 0.02);
  EXPECT_NEAR(error["triple product, 25 of visibility"], error["fixed light, 25 of visibility"],
              1e-3);
  EXPECT_LT(error["289 nodes, alpha 0.4"], error["81 nodes, alpha 0.4"]);
  EXPECT_NEAR(static_cast<double>(bytes["25 x 25, all elements"]) /
                  static_cast<double>(bytes["fixed light, 81 of visibility"]),
              625.0 / 81.0, 1e-9);
}

TEST(GlossyBench, MeasuresEveryCaseAndStopsWhenAsked) {
  const auto rows = measureGlossy({.seed = 1, .receivers = 100, .seconds_per_case = 0.0}, {});
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->size(), glossyBenchCases(100, 1).size());
  for (const GlossyBenchRow& row : *rows) EXPECT_GT(row.ms, 0.0);
  const std::string text = formatGlossyBenchRows(*rows);
  EXPECT_THAT(text,
              StartsWith("task,method,bands,items,ms,bytes,rms_error\nmatrices,\"25 x 25, all"));
  EXPECT_THAT(text, HasSubstr("clusters"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), rows->size() + 1);

  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measureGlossy({.receivers = 100}, {nullptr, stop.get_token()}));
}

}  // namespace
}  // namespace soffit::design
