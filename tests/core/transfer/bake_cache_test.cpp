// SPDX-License-Identifier: MIT
#include "core/transfer/bake_cache.h"

#include "core/transfer/cache_key.h"
#include "tests/core/transfer/scratch_folder.h"
#include "tests/core/transfer/small_bake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <iterator>
#include <stop_token>
#include <thread>

namespace soffit::transfer {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kKey;
using testing::readAll;
using testing::ScopedVariable;
using testing::ScratchFolder;
using testing::smallBake;
using ::testing::StartsWith;
using testing::stored;
using testing::writeAll;

TEST(ReadCache, NothingThereIsNoTrouble) {
  const ScratchFolder folder;
  const CacheRead read = readCache(folder.path() / "a.bake", kKey);
  EXPECT_EQ(read.operators, nullptr);
  EXPECT_EQ(read.trouble, "");
}

TEST(ReadCache, DamageIsALineThatNamesTheFile) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a.bake";
  writeAll(path, "SOFFBAKE but not really");
  const CacheRead read = readCache(path, kKey);
  EXPECT_EQ(read.operators, nullptr);
  EXPECT_EQ(
      read.trouble,
      path.string() + ": the stored bake is damaged (it ends too early), so it is baked again.");
  const CacheRead a_folder = readCache(folder.path(), kKey);
  EXPECT_EQ(a_folder.operators, nullptr);
  EXPECT_THAT(a_folder.trouble, HasSubstr("it is not a file that can be read"));
}

TEST(WriteCache, MakesTheFolderAndLeavesOneFile) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "new" / "deeper" / "a.bake";
  ASSERT_TRUE(writeCache(path, kKey, smallBake()));
  EXPECT_TRUE(readAll(path) == stored(smallBake()));
  EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1);
  const CacheRead read = readCache(path, kKey);
  ASSERT_NE(read.operators, nullptr);
  EXPECT_EQ(read.trouble, "");
  EXPECT_TRUE(stored(*read.operators) == stored(smallBake()));
}

TEST(WriteCache, ReplacesWhatIsThere) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a.bake";
  writeAll(path, "old");
  ASSERT_TRUE(writeCache(path, kKey, smallBake()));
  EXPECT_NE(readCache(path, kKey).operators, nullptr);
}

TEST(WriteCache, AFolderThatCannotBeMadeIsAnError) {
  const ScratchFolder folder;
  writeAll(folder.path() / "file", "");
  const auto written = writeCache(folder.path() / "file" / "a.bake", kKey, smallBake());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().what, StartsWith("the bake cannot be stored: "));
  EXPECT_THAT(written.error().hint, HasSubstr("SOFFIT_CACHE"));
}

TEST(WriteCache, APathThatIsAFolderIsAnErrorAndLeavesNothing) {
  const ScratchFolder folder;
  fs::create_directories(folder.path() / "a.bake" / "full");
  EXPECT_FALSE(writeCache(folder.path() / "a.bake", kKey, smallBake()));
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WriteCache, RefusesWhatCouldNotBeRead) {
  const ScratchFolder folder;
  Operators wrong = smallBake();
  wrong.fill_from[0] = 1U << 30U;
  const auto written = writeCache(folder.path() / "a.bake", kKey, wrong);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().what, "the bake cannot be stored: its texel areas do not fit together");
  EXPECT_EQ(folder.fileCount(), 0U);
}

/// No file may grow beyond `bytes` while this lives: a disk that runs full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int) = nullptr;
};

TEST(WriteCache, AFullDiskIsAnErrorAndTheOldFileStays) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a.bake";
  ASSERT_TRUE(writeCache(path, kKey, smallBake()));
  const auto size = fs::file_size(path);
  for (const rlim_t room : {rlim_t{0}, rlim_t{1000}, static_cast<rlim_t>(size - 1)}) {
    const FullDisk full(room);
    const auto written = writeCache(path, kKey, smallBake());
    ASSERT_FALSE(written) << room;
    EXPECT_THAT(written.error().what, StartsWith("the bake cannot be stored: "));
  }
  EXPECT_EQ(folder.fileCount(), 1U) << "nothing half written is left";
  EXPECT_NE(readCache(path, kKey).operators, nullptr);
}

TEST(WriteCache, WritersAtTheSameTimeLeaveAWholeFileAtEveryMoment) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a.bake";
  ASSERT_TRUE(writeCache(path, kKey, smallBake()));
  const auto write = [&](const std::stop_token&) {
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(writeCache(path, kKey, smallBake()));
  };
  {
    const std::jthread a(write);
    const std::jthread b(write);
    for (int i = 0; i < 30; ++i) {
      const CacheRead read = readCache(path, kKey);
      EXPECT_NE(read.operators, nullptr) << read.trouble;
    }
  }
  EXPECT_TRUE(readAll(path) == stored(smallBake()));
  EXPECT_EQ(folder.fileCount(), 1U);
}

class BakeOrLoad : public ::testing::Test {
 protected:
  Result<std::shared_ptr<const Operators>> run(bool use_cache = true, const Job& job = {}) {
    messages.clear();
    coarse_results = 0;
    return bakeOrLoad(
        *scene, testing::smallSettings(), use_cache, job, [&](const auto&) { ++coarse_results; },
        &counts, cached, messages);
  }
  [[nodiscard]] fs::path file() const {
    return cachePath(cacheKey(*scene, testing::smallSettings()));
  }

  ScratchFolder folder;
  ScopedVariable variable{"SOFFIT_CACHE", folder.path().c_str()};
  std::shared_ptr<const StaticScene> scene = testing::sceneOf(testing::roomMesh());
  BakeCounts counts;
  bool cached = false;
  int coarse_results = 0;
  std::vector<std::string> messages;
};

TEST_F(BakeOrLoad, BakesOnceThenLoads) {
  const auto first = run();
  ASSERT_TRUE(first);
  EXPECT_FALSE(cached);
  EXPECT_EQ(coarse_results, 1);
  EXPECT_GT(counts.rays, 0U);
  EXPECT_TRUE(fs::exists(file()));
  const auto second = run();
  ASSERT_TRUE(second);
  EXPECT_TRUE(cached);
  EXPECT_EQ(coarse_results, 0);
  EXPECT_EQ(counts.rays, 0U);
  EXPECT_GT(counts.seconds, 0.0);
  EXPECT_THAT(messages, IsEmpty());
  EXPECT_TRUE(stored(**first) == stored(**second));
}

TEST_F(BakeOrLoad, WithoutTheCacheNothingIsReadOrWritten) {
  ASSERT_TRUE(run(false));
  EXPECT_FALSE(cached);
  EXPECT_EQ(folder.fileCount(), 0U);
  ASSERT_TRUE(run());
  ASSERT_TRUE(run(false));
  EXPECT_FALSE(cached);
}

TEST_F(BakeOrLoad, ADamagedFileIsBakedAgainWithAMessage) {
  ASSERT_TRUE(run());
  std::string bytes = readAll(file());
  bytes[bytes.size() / 2] ^= 1;
  writeAll(file(), bytes);
  const auto again = run();
  ASSERT_TRUE(again);
  EXPECT_FALSE(cached);
  EXPECT_THAT(messages, ElementsAre(HasSubstr("the stored bake is damaged")));
  ASSERT_TRUE(run());
  EXPECT_TRUE(cached) << "the new bake has taken the damaged one's place";
  EXPECT_THAT(messages, IsEmpty());
}

TEST_F(BakeOrLoad, AFileOfAnotherMeshIsNotUsed) {
  geometry::Mesh other = testing::roomMesh();
  other.triangles.resize(24);
  other.material_of.resize(24);
  const auto baked = bake(*testing::sceneOf(other), testing::smallSettings(), {}, {});
  ASSERT_TRUE(baked);
  ASSERT_TRUE(writeCache(file(), cacheKey(*scene, testing::smallSettings()), **baked));
  ASSERT_TRUE(run());
  EXPECT_FALSE(cached);
  EXPECT_THAT(messages, ElementsAre(HasSubstr("it belongs to another scene")));
}

TEST_F(BakeOrLoad, AFolderThatCannotBeWrittenIsAMessageOnly) {
  writeAll(folder.path() / "file", "");
  const ScopedVariable under_a_file("SOFFIT_CACHE", (folder.path() / "file").c_str());
  const auto result = run();
  ASSERT_TRUE(result);
  EXPECT_FALSE(cached);
  EXPECT_THAT(messages, ElementsAre(HasSubstr("the bake cannot be stored")));
  EXPECT_TRUE(stored(**result) == stored(smallBake()));
}

TEST_F(BakeOrLoad, ACancelledBakeIsNotStored) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(run(true, {.stop = stop.get_token()}));
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST_F(BakeOrLoad, FreeSpaceIsNotStored) {
  scene = testing::sceneOf({});
  ASSERT_TRUE(run());
  EXPECT_FALSE(cached);
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace soffit::transfer
