// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"
#include "tests/app/cli/run_program.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace soffit {
namespace {

using testing::HasSubstr;

TEST(InfoCommand, SaysWhatIsInAProject) {
  const io::ProjectFolder folder;
  folder.write("p.soffit", io::kFullProject);
  const auto result = runSoffit(folder, {"info", folder.path().string()});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* part : {"Room", "As planned, Evening", "Entrance", "Desks", "not known"}) {
    EXPECT_THAT(result.out, HasSubstr(part));
  }
}

TEST(InfoCommand, PrintsOneJsonObject) {
  const io::ProjectFolder folder;
  folder.write("p.soffit", io::kFullProject);
  const auto result = runSoffit(folder, {"info", folder.path().string(), "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  EXPECT_EQ(json->find("triangles")->asNumber()->value, 3.0);
  EXPECT_EQ(json->find("luminaires")->asNumber()->value, 2.0);
  EXPECT_NE(json->find("receivers")->asNumber(), nullptr);
  EXPECT_FALSE(json->find("needed")->asArray()->empty());
  for (const io::Json& skipped : *json->find("skipped")->asArray()) {
    EXPECT_NE(skipped.find("what")->asText(), nullptr);
    EXPECT_NE(skipped.find("why")->asText(), nullptr);
  }
}

TEST(InfoCommand, SaysBeforehandWhatTheBakeTakes) {
  const io::ProjectFolder folder;
  const std::string project = SOFFIT_SOURCE_DIR "/projects/cornell";
  const auto numberOf = [](const ProgramResult& result, const char* name) {
    EXPECT_EQ(result.status, 0) << result.err;
    const auto json = io::parseJson(result.out, "stdout");
    return json.ok() ? json->find(name)->asNumber()->value : 0.0;
  };
  const auto info = runSoffit(folder, {"info", project, "--json"});
  const auto bake = runSoffit(folder, {"bake", project, "--json"});
  EXPECT_NEAR(numberOf(info, "receivers") / numberOf(bake, "receivers"), 1.0, 0.1);
  EXPECT_NEAR(numberOf(info, "megabytes") / (numberOf(bake, "bytes") / 1.0e6), 1.0, 0.25);
  EXPECT_GT(numberOf(info, "bake_seconds"), 0.0);  // how many depends on who else is at work
}

TEST(InfoCommand, HonoursLayoutAndSettings) {
  const io::ProjectFolder folder;
  const std::string file = folder.write("p.soffit", io::kFullProject);
  const auto result =
      runSoffit(folder, {"info", file, "--layout", "Evening", "--set", "luminaires.Candle.flux=5",
                         "--set", "name=Other", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  EXPECT_EQ(json->find("luminaires")->asNumber()->value, 3.0);
  EXPECT_EQ(*json->find("name")->asText(), "Other");
}

}  // namespace
}  // namespace soffit
