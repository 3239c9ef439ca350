// SPDX-License-Identifier: MIT
#include "core/transfer/cache_folder.h"

#include "tests/core/transfer/scratch_folder.h"

#include <gtest/gtest.h>

#include <chrono>

namespace soffit::transfer {
namespace {

namespace fs = std::filesystem;
using testing::ScopedVariable;
using testing::ScratchFolder;
using testing::writeAll;

TEST(CacheFolder, OwnVariableComesFirst) {
  const ScopedVariable own("SOFFIT_CACHE", "/somewhere/else");
  EXPECT_EQ(cacheFolder(), fs::path("/somewhere/else"));
}

#if defined(__linux__)
TEST(CacheFolder, FollowsTheXdgSpecification) {
  const ScopedVariable own("SOFFIT_CACHE", nullptr);
  const ScopedVariable home("HOME", "/home/ada");
  const ScopedVariable xdg("XDG_CACHE_HOME", "/var/caches/ada");
  EXPECT_EQ(cacheFolder(), fs::path("/var/caches/ada/soffit"));
  const ScopedVariable relative("XDG_CACHE_HOME", "caches");
  EXPECT_EQ(cacheFolder(), fs::path("/home/ada/.cache/soffit"));
  const ScopedVariable none("XDG_CACHE_HOME", nullptr);
  EXPECT_EQ(cacheFolder(), fs::path("/home/ada/.cache/soffit"));
}

TEST(CacheFolder, WithoutAHomeItIsTemporary) {
  const ScopedVariable own("SOFFIT_CACHE", "");
  const ScopedVariable home("HOME", nullptr);
  const ScopedVariable xdg("XDG_CACHE_HOME", nullptr);
  EXPECT_EQ(cacheFolder(), fs::temp_directory_path() / "soffit-cache");
}
#endif

fs::path makeFile(const ScratchFolder& folder, const char* name, std::size_t bytes, int hours_ago) {
  const fs::path path = folder.path() / name;
  writeAll(path, std::string(bytes, 'x'));
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours_ago));
  return path;
}

TEST(TrimCache, RemovesTheLeastRecentlyUsedOnly) {
  const ScratchFolder folder;
  const fs::path oldest = makeFile(folder, "a.bake", 100, 30);
  const fs::path old = makeFile(folder, "b.bake", 100, 20);
  const fs::path recent = makeFile(folder, "c.bake", 100, 10);
  const fs::path foreign = makeFile(folder, "notes.txt", 1000, 99);
  trimCache(folder.path(), 300, recent);
  EXPECT_TRUE(fs::exists(oldest)) << "300 bytes are within the limit";
  touchBake(oldest);
  trimCache(folder.path(), 299, recent);
  EXPECT_TRUE(fs::exists(oldest)) << "it was used just now";
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(recent));
  EXPECT_TRUE(fs::exists(foreign)) << "what is not ours stays";
}

TEST(TrimCache, KeepsWhatWasJustWritten) {
  const ScratchFolder folder;
  const fs::path large = makeFile(folder, "a.bake", 500, 2);
  const fs::path other = makeFile(folder, "b.bake", 10, 1);
  trimCache(folder.path(), 100, large);
  EXPECT_TRUE(fs::exists(large));
  EXPECT_FALSE(fs::exists(other));
}

TEST(TrimCache, ClearsUpAfterWritersThatWereKilled) {
  const ScratchFolder folder;
  const fs::path dead = makeFile(folder, "a.bake.0123456789abcdef.tmp", 10, 25);
  const fs::path alive = makeFile(folder, "a.bake.fedcba9876543210.tmp", 10, 1);
  const fs::path foreign = makeFile(folder, "letter.tmp", 10, 99);
  trimCache(folder.path(), 100, folder.path() / "a.bake");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_TRUE(fs::exists(foreign));
}

TEST(TrimCache, AMissingFolderIsNoFault) {
  const ScratchFolder folder;
  trimCache(folder.path() / "nowhere", 0, "a.bake");
  EXPECT_FALSE(fs::exists(folder.path() / "nowhere"));
}

}  // namespace
}  // namespace soffit::transfer
