// SPDX-License-Identifier: MIT
#include "core/io/model/model_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/io/model/scratch_folder.h"

namespace soffit::io {
namespace {

using ::testing::HasSubstr;

TEST(LiesInFolder, ResolvesDotsAndLinks) {
  const ScratchFolder scratch;
  scratch.write("project/maps/a.png", "x");
  scratch.write("project2/b.png", "x");
  const auto project = scratch.path() / "project";
  EXPECT_TRUE(liesInFolder(project / "maps" / "a.png", project));
  EXPECT_TRUE(liesInFolder(project / "maps" / ".." / "new.png", project));
  EXPECT_FALSE(liesInFolder(project / ".." / "project2" / "b.png", project));
  EXPECT_FALSE(liesInFolder(scratch.path() / "project2" / "b.png", project));
  std::filesystem::create_directory_symlink(scratch.path() / "project2", project / "link");
  EXPECT_FALSE(liesInFolder(project / "link" / "b.png", project));
}

TEST(FindTexture, KnowsTheSpellingsOfExporters) {
  const ScratchFolder scratch;
  const auto model = scratch.path() / "models" / "a.obj";
  scratch.write("models/maps/oak.png", "x");
  scratch.write("models/wide oak.png", "x");
  scratch.write("shared.png", "x");
  const auto found = [&](const char* name) {
    return findTexture(name, model, scratch.path()).relative;
  };
  EXPECT_EQ(found("maps/oak.png"), "maps/oak.png");
  EXPECT_EQ(found("maps\\oak.png"), "maps/oak.png");
  EXPECT_EQ(found("wide%20oak.png"), "wide oak.png");
  EXPECT_EQ(found("C:\\Users\\me\\Desktop\\wide oak.png"), "wide oak.png");
  EXPECT_EQ(found("/home/me/wide oak.png"), "wide oak.png");
  EXPECT_EQ(found("../shared.png"), "../shared.png");
}

TEST(FindTexture, SaysWhyNot) {
  const ScratchFolder scratch;
  const auto model = scratch.path() / "project" / "a.obj";
  scratch.write("project/a.obj", "x");
  scratch.write("outside.png", "x");
  const auto problem = [&](const char* name) {
    const TexturePath path = findTexture(name, model, scratch.path() / "project");
    EXPECT_EQ(path.relative, "");
    return path.problem;
  };
  EXPECT_THAT(problem("gone.png"), HasSubstr("'gone.png' does not exist"));
  EXPECT_THAT(problem("../outside.png"), HasSubstr("outside of the project's folder"));
  EXPECT_THAT(problem(""), HasSubstr("does not exist"));
  EXPECT_THAT(problem("%00%zz%2"), HasSubstr("does not exist"));
}

}  // namespace
}  // namespace soffit::io
