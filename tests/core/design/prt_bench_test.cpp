// SPDX-License-Identifier: MIT
#include "core/design/prt_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace soffit::design {
namespace {

using testing::StartsWith;

const std::vector<PrtBenchRow>& rows() {
  static const auto measured = measurePrt({.seed = 3, .seconds_per_case = 0.0, .detail = 0}, {});
  return measured.value();
}

TEST(PrtBench, EveryTaskIsMeasured) {
  std::map<std::string, int> count;
  for (const PrtBenchRow& r : rows()) {
    ++count[r.task];
    EXPECT_GT(r.ms, 0.0) << r.task;
    EXPECT_GT(r.receivers, 0U);
    EXPECT_TRUE(std::isfinite(r.rms_error));
  }
  EXPECT_EQ(count["apply"], 8 * 3);
  EXPECT_EQ(count["samples"], 9);
  EXPECT_EQ(count["bands"], 10);
  EXPECT_EQ(count["bounces"], 4);
  EXPECT_EQ(count["places"], 2);
  EXPECT_EQ(count["texture"], 2);
}

TEST(PrtBench, ErrorsFallWhereTheyShould) {
  std::map<std::string, double> samples;
  std::vector<double> bands;
  for (const PrtBenchRow& r : rows()) {
    if (r.task == "apply") {
      EXPECT_LT(r.rms_error, 3e-4);
    }
    if (r.task == "samples" && r.samples == 4096) samples[r.method] = r.rms_error;
    if (r.task == "bands") bands.push_back(r.rms_error);
  }
  EXPECT_LT(samples["stratified"], samples["random"]);
  EXPECT_LT(samples["hammersley"], samples["random"]);
  EXPECT_LT(bands[4], bands[1]);
  EXPECT_LT(bands[9], bands[4]);
}

TEST(PrtBench, IsWrittenAsATable) {
  const std::string text = formatPrtBenchRows(rows());
  EXPECT_THAT(text, StartsWith("task,method,bands,samples,receivers,ms,cpu_ms,rays,megabytes,rms_error\n"
                               "apply,one channel,3,0,1000,"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            rows().size() + 1);
}

TEST(PrtBench, OneTaskCanBePicked) {
  EXPECT_EQ(prtBenchTasks().front(), "apply");
  const auto one = measurePrt({.only = "bands", .detail = 0}, {});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->size(), 10U);
  EXPECT_EQ(one->front().task, "bands");
}

TEST(PrtBench, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measurePrt({.detail = 0}, {nullptr, stop.get_token()}));
}

}  // namespace
}  // namespace soffit::design
