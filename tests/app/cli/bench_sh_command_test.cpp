// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"
#include "tests/app/cli/run_program.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace soffit {
namespace {

using testing::HasSubstr;

TEST(BenchShCommand, PrintsJsonAndWritesTheTable) {
  const io::ProjectFolder folder;
  const auto out = folder.path() / "figures";
  const auto result = runSoffit(folder, {"bench", "sh", "--json", "-o", out.string()});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  const auto* rows = json->find("rows")->asArray();
  ASSERT_NE(rows, nullptr);
  EXPECT_GT(rows->size(), 40U);
  EXPECT_GT(rows->front().find("ns")->asNumber()->value, 0.0);
  EXPECT_TRUE(std::filesystem::exists(out / "sh.csv"));
}

TEST(BenchShCommand, RefusesAProject) {
  const io::ProjectFolder folder;
  EXPECT_EQ(runSoffit(folder, {"bench", "sh", "office"}).status, 2);
}

}  // namespace
}  // namespace soffit
