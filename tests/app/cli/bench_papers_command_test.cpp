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

TEST(BenchPapersCommand, PrintsJsonAndWritesTheTable) {
  const io::ProjectFolder folder;
  const auto out = folder.path() / "figures";
  const auto result = runSoffit(folder, {"bench", "papers", "--triangles", "600", "--side", "64",
                                         "--directions", "16", "--json", "-o", out.string()});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  const auto* rows = json->find("rows")->asArray();
  ASSERT_NE(rows, nullptr);
  EXPECT_EQ(rows->size(), 25U);
  EXPECT_GT(rows->front().find("ours")->asNumber()->value, 0.0);
  EXPECT_EQ(rows->front().find("published"), nullptr) << "not known, not invented";
  EXPECT_TRUE(std::filesystem::exists(out / "papers.csv"));
}

TEST(BenchPapersCommand, SaysWhichFiguresAreNotKnown) {
  const io::ProjectFolder folder;
  const auto result = runSoffit(
      folder, {"bench", "papers", "--triangles", "600", "--side", "64", "--directions", "16"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("not given here"));
  EXPECT_THAT(result.out, HasSubstr("5.2, 83.6"));
}

TEST(BenchPapersCommand, RefusesAProjectAndAFolderThatIsAFile) {
  const io::ProjectFolder folder;
  EXPECT_EQ(runSoffit(folder, {"bench", "papers", "office"}).status, 2);
  const auto taken = runSoffit(folder, {"bench", "papers", "-o", "/dev/null"});
  EXPECT_EQ(taken.status, 1);
  EXPECT_THAT(taken.err, HasSubstr("papers.csv"));
}

}  // namespace
}  // namespace soffit
