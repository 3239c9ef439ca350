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

TEST(BenchGlossyCommand, PrintsJsonAndWritesTheTable) {
  const io::ProjectFolder folder;
  const auto out = folder.path() / "figures";
  const auto result =
      runSoffit(folder, {"bench", "glossy", "--json", "--receivers", "200", "-o", out.string()});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  const auto* rows = json->find("rows")->asArray();
  ASSERT_NE(rows, nullptr);
  EXPECT_GT(rows->size(), 10U);
  EXPECT_GT(rows->front().find("ms")->asNumber()->value, 0.0);
  EXPECT_TRUE(json->find("pictures")->asArray()->empty());
  EXPECT_TRUE(std::filesystem::exists(out / "glossy.csv"));
  EXPECT_FALSE(std::filesystem::exists(out / "glossy_pictures.csv"));
}

TEST(BenchGlossyCommand, NamesWhatIsWrong) {
  const io::ProjectFolder folder;
  const auto missing = runSoffit(folder, {"bench", "glossy", "nowhere"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, HasSubstr("nowhere"));
  EXPECT_EQ(runSoffit(folder, {"bench", "glossy", "--stride", "0"}).status, 2);
}

}  // namespace
}  // namespace soffit
