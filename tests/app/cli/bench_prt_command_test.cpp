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

TEST(BenchPrtCommand, PrintsJsonAndWritesTheTable) {
  const io::ProjectFolder folder;
  const auto out = folder.path() / "figures";
  const auto result =
      runSoffit(folder, {"bench", "prt", "--detail", "0", "--json", "-o", out.string()});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  const auto* rows = json->find("rows")->asArray();
  ASSERT_NE(rows, nullptr);
  EXPECT_GT(rows->size(), 30U);
  EXPECT_GT(rows->front().find("ms")->asNumber()->value, 0.0);
  EXPECT_TRUE(std::filesystem::exists(out / "prt.csv"));
}

TEST(BenchPrtCommand, RefusesAProject) {
  const io::ProjectFolder folder;
  EXPECT_EQ(runSoffit(folder, {"bench", "prt", "office"}).status, 2);
}

}  // namespace
}  // namespace soffit
