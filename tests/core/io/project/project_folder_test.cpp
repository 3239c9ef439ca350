// SPDX-License-Identifier: MIT
#include "core/io/project/project_folder.h"

#include "core/io/project/project.h"
#include "tests/core/io/project/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace soffit::io {
namespace {

namespace fs = std::filesystem;

std::string errorOf(const TemporaryFolder& folder, const std::string& file) {
  const auto found = fileInFolder(folder.path() / "project", file);
  return found ? std::string() : found.error().message();
}

TEST(FileInFolder, FindsFilesInAndBelow) {
  const TemporaryFolder folder;
  folder.write("project/a.obj", "");
  folder.write("project/maps/b.png", "");
  for (const char* file : {"a.obj", "./a.obj", "maps/b.png", "maps/../a.obj"}) {
    EXPECT_EQ(errorOf(folder, file), "") << file;
  }
}

TEST(FileInFolder, NothingLeavesTheFolder) {
  const TemporaryFolder folder;
  folder.write("outside.obj", "");
  folder.write("project2/a.obj", "");
  folder.write("project/a.obj", "");
  fs::create_symlink("../outside.obj", folder.path() / "project" / "link.obj");
  fs::create_directory_symlink("../project2", folder.path() / "project" / "folder");
  fs::create_symlink("a.obj", folder.path() / "project" / "inside.obj");
  const std::string hint =
      " leaves the project's folder. Copy the file beside the project and name it there.";
  for (const std::string file : {"../outside.obj", "maps/../../outside.obj", "link.obj",
                                 "folder/a.obj", "../project2/a.obj", "/etc/passwd"}) {
    EXPECT_EQ(errorOf(folder, file), "\"" + file + "\"" + hint);
  }
  EXPECT_EQ(errorOf(folder, (folder.path() / "project" / "a.obj").string()).find("leaves") ==
                std::string::npos,
            false)
      << "absolute names are refused even when they lie inside";
  EXPECT_EQ(errorOf(folder, "inside.obj"), "") << "a link that stays inside is fine";
}

TEST(FileInFolder, SaysWhatIsMissing) {
  const TemporaryFolder folder;
  folder.write("project/maps/b.png", "");
  EXPECT_EQ(errorOf(folder, "a.obj"),
            "there is no file \"a.obj\". Put it beside the project, or correct the name.");
  EXPECT_EQ(errorOf(folder, "maps\\b.png"),
            "there is no file \"maps\\b.png\". Write forward slashes in the name.");
  EXPECT_EQ(errorOf(folder, ""), "the name of the file is empty. Name a file beside the project.");
  EXPECT_EQ(errorOf(folder, "maps"), "\"maps\" is not a file. Name a file.");
}

TEST(FindProjectFile, AFolderStandsForItsOnlyProject) {
  const TemporaryFolder folder;
  const std::string place = folder.path().string();
  EXPECT_EQ(findProjectFile(folder.path()).error().message(),
            place + ": the folder holds no .soffit file. Name the project file.");
  const fs::path file = folder.write("a.soffit", "{}");
  folder.write("a.soffit~", "{}");
  EXPECT_EQ(*findProjectFile(folder.path()), file);
  EXPECT_EQ(*findProjectFile(file), file);
  folder.write("b.soffit", "{}");
  EXPECT_EQ(findProjectFile(folder.path()).error().message(),
            place + ": the folder holds 2 .soffit files. Name the one that is meant.");
  EXPECT_EQ(findProjectFile(folder.path() / "none").error().what, "there is no such project");
  EXPECT_EQ(findProjectFile("/dev/null").error().what, "this is not a file");
}

}  // namespace
}  // namespace soffit::io
