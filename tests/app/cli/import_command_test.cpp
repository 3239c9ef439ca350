// SPDX-License-Identifier: MIT
#include "tests/app/cli/run_program.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace soffit {
namespace {

using testing::StartsWith;

TEST(ImportCommand, WritesAProjectThatInfoReads) {
  const io::ProjectFolder folder;
  const std::string project = (folder.path() / "out" / "room.soffit").string();
  const auto made =
      runSoffit(folder, {"import", (folder.path() / "quad.obj").string(), "-o", project});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, StartsWith(project + ": 3 triangles, 2 materials"));
  EXPECT_TRUE(folder.has("out/quad.obj"));
  EXPECT_TRUE(folder.has("out/quad.mtl"));
  EXPECT_EQ(runSoffit(folder, {"info", project}).status, 0);
}

TEST(ImportCommand, ABrokenModelLeavesNothingBehind) {
  const io::ProjectFolder folder;
  const std::string broken = folder.write("broken.ifc", "ISO-10303-21;\nHEADER;\nrubbish");
  const std::string project = (folder.path() / "out" / "room.soffit").string();
  const auto result = runSoffit(folder, {"import", broken, "-o", project});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1) << result.err;
  EXPECT_FALSE(folder.has("out"));
}

}  // namespace
}  // namespace soffit
