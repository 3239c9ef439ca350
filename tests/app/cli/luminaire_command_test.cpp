// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"
#include "tests/app/cli/run_program.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace soffit {
namespace {

using testing::HasSubstr;

TEST(LuminaireCommand, PrintsTheFileAsJson) {
  const io::ProjectFolder folder;
  const auto result =
      runSoffit(folder, {"luminaire", (folder.path() / "spot.ies").string(), "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = io::parseJson(result.out, "stdout");
  ASSERT_TRUE(json) << json.error().message();
  // 100 cd over the lower hemisphere: 200 pi lm, by an exact integral.
  constexpr double kRoundoff = 1e-11;
  EXPECT_NEAR(json->find("lumens")->asNumber()->value, 200.0 * std::numbers::pi, kRoundoff);
  EXPECT_EQ(json->find("n_vertical")->asNumber()->value, 3.0);
  EXPECT_EQ(json->find("n_horizontal")->asNumber()->value, 1.0);
  EXPECT_THAT(*json->find("format")->asText(), HasSubstr("LM-63-2002"));
  EXPECT_NE(json->find("symmetry")->asText(), nullptr);
  EXPECT_NE(json->find("warnings")->asArray(), nullptr);
}

TEST(LuminaireCommand, PrintsTheFileForPeople) {
  const io::ProjectFolder folder;
  const auto result = runSoffit(folder, {"luminaire", (folder.path() / "spot.ies").string()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("628.3"));
}

TEST(LuminaireCommand, ABrokenFileIsOneLineOnStderr) {
  const io::ProjectFolder folder;
  const auto result = runSoffit(folder, {"luminaire", folder.write("x.ies", "IESNA:LM-63-2002\n")});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1) << result.err;
  EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace soffit
