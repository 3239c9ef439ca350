// SPDX-License-Identifier: MIT
#include "core/transfer/cache_file.h"

#include "core/transfer/cache_key.h"
#include "core/transfer/content_hash.h"
#include "core/transfer/operator_arrays.h"
#include "tests/core/transfer/small_bake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soffit::transfer {
namespace {

using ::testing::HasSubstr;
using testing::kKey;
using testing::smallBake;
using testing::stored;

ReadOperators readBack(const std::string& bytes, std::string_view key = kKey) {
  std::istringstream in(bytes);
  return readOperators(in, bytes.size(), key);
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSameTexels(const Texels& a, const Texels& b) {
  const light::Receivers& r = a.receivers;
  const light::Receivers& s = b.receivers;
  EXPECT_TRUE(same(r.x, s.x) && same(r.y, s.y) && same(r.z, s.z));
  EXPECT_TRUE(same(r.nx, s.nx) && same(r.ny, s.ny) && same(r.nz, s.nz));
  EXPECT_TRUE(same(r.slot_of, s.slot_of) && same(r.point_of, s.point_of));
  EXPECT_TRUE(same(r.clusters, s.clusters) && same(r.groups, s.groups));
  EXPECT_TRUE(same(a.area, b.area) && same(a.material, b.material) && same(a.triangle, b.triangle));
  EXPECT_TRUE(same(a.uv, b.uv) && same(a.uv_width, b.uv_width));
  EXPECT_TRUE(same(a.openness, b.openness));
  EXPECT_TRUE(same(a.part, b.part) && same(a.split, b.split));
  EXPECT_TRUE(same(a.grids, b.grids) && same(a.cells, b.cells));
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_TRUE(same(a.charts.triangles, b.charts.triangles) &&
              same(a.charts.chart_of, b.charts.chart_of));
  ASSERT_EQ(a.charts.charts.size(), b.charts.charts.size());
  for (std::size_t i = 0; i < a.charts.charts.size(); ++i) {
    const Chart& c = a.charts.charts[i];
    const Chart& d = b.charts.charts[i];
    EXPECT_TRUE(c.planar == d.planar && c.sides == d.sides && c.material == d.material &&
                c.origin == d.origin && c.t == d.t && c.b == d.b && c.normal == d.normal &&
                c.size == d.size && c.area == d.area && c.first_triangle == d.first_triangle &&
                c.triangle_count == d.triangle_count);
  }
}

void expectSame(const Operators& a, const Operators& b) {
  expectSameTexels(a.texels, b.texels);
  EXPECT_TRUE(same(a.area, b.area) && same(a.fill_from, b.fill_from) && same(a.buried, b.buried) && same(a.sends, b.sends));
  EXPECT_TRUE(same(a.nodes.patches, b.nodes.patches) && same(a.nodes.patch_of, b.nodes.patch_of));
  EXPECT_TRUE(same(a.nodes.phi, b.nodes.phi) && same(a.nodes.matrix.first, b.nodes.matrix.first));
  EXPECT_TRUE(same(a.nodes.matrix.blocks, b.nodes.matrix.blocks));
  EXPECT_EQ(a.nodes.functions, b.nodes.functions);
  EXPECT_EQ(a.nodes.stride, b.nodes.stride);
  EXPECT_TRUE(same(a.lists.entries, b.lists.entries));
  EXPECT_TRUE(same(a.lists.lists, b.lists.lists) && same(a.node_lists.lists, b.node_lists.lists));
  EXPECT_TRUE(same(a.node_lists.entries, b.node_lists.entries));
  EXPECT_TRUE(same(a.clusters, b.clusters) && same(a.weights, b.weights) &&
              same(a.list_area, b.list_area));
  EXPECT_EQ(a.coarse, b.coarse);
  EXPECT_EQ(a.bytes(), b.bytes());
}

constexpr std::size_t kBlocks = 43;  // of operator_arrays.h

TEST(CacheFile, RoundTripKeepsEveryMember) {
  const Operators& baked = smallBake();
  std::size_t blocks = 0;
  const Records records = recordsOf(baked);
  forEachArray(baked, records, [&](std::string_view name, const auto& array) {
    EXPECT_FALSE(array.empty()) << name << ": nothing to compare";
    ++blocks;
  });
  EXPECT_EQ(blocks, kBlocks);
  const auto& charts = baked.texels.charts.charts;
  EXPECT_TRUE(std::any_of(charts.begin(), charts.end(), [](const Chart& c) { return !c.planar; }));
  const ReadOperators read = readBack(stored(baked));
  EXPECT_EQ(read.trouble, "");
  ASSERT_NE(read.operators, nullptr);
  expectSame(baked, *read.operators);
}

TEST(CacheFile, RoundTripOfCoarseOperators) {
  std::shared_ptr<const Operators> coarse;
  const auto scene = testing::sceneOf(testing::roomMesh());
  ASSERT_TRUE(
      bake(*scene, testing::smallSettings(), {}, [&](auto early) { coarse = std::move(early); }));
  const ReadOperators read = readBack(stored(*coarse));
  EXPECT_EQ(read.trouble, "");
  ASSERT_NE(read.operators, nullptr);
  expectSame(*coarse, *read.operators);
}

TEST(CacheFile, EqualOperatorsGiveEqualFiles) {
  const auto again = bake(*testing::sceneOf(testing::roomMesh()), testing::smallSettings(), {}, {});
  ASSERT_TRUE(again);
  EXPECT_TRUE(stored(smallBake()) == stored(**again));
}

TEST(CacheFile, StopsWhenTheSinkFails) {
  std::size_t room = 5000;
  EXPECT_FALSE(writeOperators(smallBake(), kKey, [&](std::span<const std::byte> bytes) {
    if (bytes.size() > room) return false;
    room -= bytes.size();
    return true;
  }));
}

// Places in the file: cache_file.cpp, Header and TableEntry.
constexpr std::size_t kVersionAt = 12;
constexpr std::size_t kKeyAt = 16;
constexpr std::size_t kSizeAt = 48;
constexpr std::size_t kTableHashAt = 64;
constexpr std::size_t kHeaderHashAt = 72;
constexpr std::size_t kTableAt = 80;
constexpr std::size_t kNameSize = 32;
constexpr std::size_t kEntrySize = 64;

template <class T>
T numberAt(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, &bytes[at], sizeof value);
  return value;
}
template <class T>
void setNumber(std::string& bytes, std::size_t at, T value) {
  std::memcpy(&bytes[at], &value, sizeof value);
}
void sign(std::string& bytes) {
  const std::size_t table_size = kBlocks * kEntrySize;
  const auto all = std::as_bytes(std::span(bytes));
  setNumber(bytes, kTableHashAt, hash64(all.subspan(kTableAt, table_size)));
  setNumber(bytes, kHeaderHashAt, hash64(all.first(kHeaderHashAt)));
}

TEST(CacheFile, NamesOfItsBlocksAreWhole) {
  const Operators none;
  const Records records;
  const std::string whole = stored(smallBake());
  std::size_t block = 0;
  forEachArray(none, records, [&](std::string_view name, const auto&) {
    EXPECT_LT(name.size(), kNameSize) << name;
    EXPECT_STREQ(&whole[kTableAt + block++ * kEntrySize], std::string(name).c_str());
  });
}

TEST(CacheFile, TruncationIsFoundWhereverItHappens) {
  const std::string whole = stored(smallBake());
  std::vector<std::size_t> sizes = {0, 1, 79, 80, 81, 200, whole.size() - 1};
  for (std::size_t i = 0; i < kBlocks; ++i) {
    const auto offset = numberAt<std::uint64_t>(whole, kTableAt + i * kEntrySize + kNameSize);
    const auto size = numberAt<std::uint64_t>(whole, kTableAt + i * kEntrySize + kNameSize + 8);
    sizes.insert(sizes.end(), {offset, offset + size / 2, offset + size - 1});
  }
  for (const std::size_t size : sizes) {
    std::string part = whole.substr(0, size);
    EXPECT_EQ(readBack(part).operators, nullptr) << size;
    EXPECT_NE(readBack(part).trouble, "") << size;
    if (size < kTableAt) continue;
    // The same when the header agrees with the truncated size.
    setNumber<std::uint64_t>(part, kSizeAt, size);
    setNumber(part, kHeaderHashAt, hash64(std::as_bytes(std::span(part)).first(kHeaderHashAt)));
    EXPECT_EQ(readBack(part).operators, nullptr) << size;
  }
}

TEST(CacheFile, SaysWhatIsWrong) {
  const std::string whole = stored(smallBake());
  const auto trouble = [&](const auto& change) {
    std::string bytes = whole;
    change(bytes);
    const ReadOperators read = readBack(bytes);
    EXPECT_EQ(read.operators, nullptr);
    return read.trouble;
  };
  const auto first = numberAt<std::uint64_t>(whole, kTableAt + kNameSize);
  EXPECT_EQ(trouble([](std::string& b) { b.clear(); }), "it ends too early");
  EXPECT_EQ(trouble([](std::string& b) { b[0] = 'X'; }), "it is no bake of Soffit's");
  EXPECT_EQ(trouble([](std::string& b) { std::swap(b[8], b[11]), std::swap(b[9], b[10]); }),
            "it comes from a machine with another byte order");
  EXPECT_THAT(trouble([](std::string& b) { setNumber(b, kVersionAt, kBakeVersion + 1); }),
              HasSubstr("it has version"));
  EXPECT_EQ(trouble([](std::string& b) { b[kKeyAt] = 'X'; }), "its header has changed");
  EXPECT_THAT(trouble([](std::string& b) { b += '\0'; }), HasSubstr("bytes instead of"));
  EXPECT_EQ(trouble([](std::string& b) { b[kTableAt + 30] ^= 1; }), "its table has changed");
  EXPECT_EQ(trouble([&](std::string& b) { b[first] ^= 1; }), "its block 'scalars' has changed");
  EXPECT_EQ(trouble([](std::string& b) {
              b.append(64, '\0');
              setNumber<std::uint64_t>(b, kSizeAt, b.size());
              sign(b);
            }),
            "its blocks do not fill it");
  EXPECT_EQ(readBack(whole, "another key of 32 characters ...").trouble,
            "it belongs to another scene");
  Operators wrong = smallBake();
  wrong.fill_from[0] = 1U << 30U;
  EXPECT_EQ(readBack(stored(wrong)).trouble, "its texel areas do not fit together");
}

// With right checksums, as only a program could make it: no size makes the reader ask for more
// memory than the file has bytes.
TEST(CacheFile, AbsurdSizesAreRefusedBeforeMemoryIsAskedFor) {
  const std::string whole = stored(smallBake());
  const std::vector<std::uint64_t> sizes = {~std::uint64_t{0}, std::uint64_t{1} << 62U,
                                            std::uint64_t{1} << 40U, whole.size(), 8};
  for (const std::uint64_t size : sizes) {
    for (std::size_t block = 0; block < kBlocks; ++block) {
      std::string bytes = whole;
      setNumber(bytes, kTableAt + block * kEntrySize + kNameSize + 8, size / 8 * 8);
      sign(bytes);
      EXPECT_EQ(readBack(bytes).operators, nullptr) << block << ' ' << size;
    }
  }
}

TEST(CacheFile, ChangedBitsAreFoundOrMeanNothing) {
  const std::string whole = stored(smallBake());
  std::mt19937 random(1);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole;
    // Half of them in the header and the table, where they would do most harm.
    const std::size_t at = random() % (i % 2 == 0 ? kTableAt + kBlocks * kEntrySize : bytes.size());
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << random() % 8U));
    const ReadOperators read = readBack(bytes);
    ASSERT_NE(read.operators == nullptr, read.trouble.empty());
    if (read.operators == nullptr) {
      ++found;
    } else {
      ASSERT_TRUE(stored(*read.operators) == whole) << "byte " << at;
    }
  }
  EXPECT_GT(found, 2900);  // the rest fell between blocks
}

}  // namespace
}  // namespace soffit::transfer
