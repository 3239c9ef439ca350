// SPDX-License-Identifier: MIT
#include "core/io/project/atomic_file.h"

#include "tests/core/io/project/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace soffit::io {
namespace {

namespace fs = std::filesystem;

TEST(WriteFileAtomically, LeavesNothingButTheFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder.path() / "a.txt", "one"));
  ASSERT_TRUE(writeFileAtomically(folder.path() / "a.txt", std::string("t\0wo", 4)));
  EXPECT_EQ(folder.read("a.txt"), std::string("t\0wo", 4));
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFileAtomically, KeepsThePreviousVersionWhenAsked) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.soffit";
  ASSERT_TRUE(writeFileAtomically(file, "one", Previous::kept_as_backup));
  EXPECT_FALSE(folder.has("a.soffit~")) << "there was nothing to keep";
  ASSERT_TRUE(writeFileAtomically(file, "two", Previous::kept_as_backup));
  ASSERT_TRUE(writeFileAtomically(file, "three", Previous::kept_as_backup));
  EXPECT_EQ(folder.read("a.soffit"), "three");
  EXPECT_EQ(folder.read("a.soffit~"), "two");
}

TEST(WriteFileAtomically, KeepsTheModeAndFollowsLinks) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("real.txt", "one");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.txt", folder.path() / "link.txt");
  ASSERT_TRUE(writeFileAtomically(folder.path() / "link.txt", "two"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(folder.read("real.txt"), "two");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteFileAtomically, ErrorsLeaveNothingBehind) {
  const TemporaryFolder folder;
  const auto missing = writeFileAtomically(folder.path() / "no" / "a.txt", "x");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().what, "the file cannot be written: No such file or directory");
  fs::create_directory(folder.path() / "sub");
  const auto is_folder = writeFileAtomically(folder.path() / "sub", "x");
  ASSERT_FALSE(is_folder);
  EXPECT_EQ(is_folder.error().what, "this is a folder, not a file");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFileAtomically, WritesToDevicesAsTheyStand) {
  EXPECT_TRUE(writeFileAtomically("/dev/null", "x"));
  const auto full = writeFileAtomically("/dev/full", "x");
  ASSERT_FALSE(full);
  EXPECT_TRUE(full.error().what.starts_with("the content cannot be written")) << full.error().what;
}

TEST(ReadFile, HasALimit) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", std::string(100, 'x'));
  EXPECT_EQ(readFile(file, 100)->size(), 100U);
  EXPECT_FALSE(readFile(file, 99));
  const auto endless = readFile("/dev/zero", std::size_t{1} << 20U);
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().what, "the file is larger than 1 MB");
  EXPECT_EQ(readFile(folder.path()).error().what, "this is a folder, not a file");
  EXPECT_EQ(readFile(folder.path() / "none").error().what, "there is no such file");
}

}  // namespace
}  // namespace soffit::io
