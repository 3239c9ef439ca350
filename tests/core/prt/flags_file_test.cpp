// SPDX-License-Identifier: MIT
#include "core/prt/flags_file.h"

#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

constexpr FlagsKey kKey{1, 2};

VisibilityFlags someFlags(bool pane) {
  Builder b = testing::blockOnFloor(4, vec3(0.5F), vec3(0.5F));
  if (pane) {
    scene::Material glass;
    glass.glass = scene::Glass{1.52, 0.8};
    b.add(testing::quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), glass);
  }
  const auto surfaces = b.surfaces();
  const VertexReceivers set(surfaces);
  return traceShadows(*surfaces, set.receivers(), {sh::hammersleySamples(100), 2}).value().flags;
}

std::string written(const VisibilityFlags& flags) {
  std::ostringstream out;
  EXPECT_TRUE(writeFlags(flags, kKey, out));
  return out.str();
}

std::string trouble(const std::string& bytes, const FlagsKey& key = kKey) {
  std::istringstream in(bytes);
  const auto read = readFlags(in, bytes.size(), key, "room.flags");
  return read.ok() ? "" : read.error().message();
}

TEST(FlagsFile, BringsBackWhatWasWritten) {
  for (const bool pane : {false, true}) {
    const VisibilityFlags flags = someFlags(pane);
    EXPECT_EQ(flags.allDimmed().empty(), !pane);
    const std::string bytes = written(flags);
    std::istringstream in(bytes);
    const auto read = readFlags(in, bytes.size(), kKey, "room.flags");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(*read == flags);
    // One bit per receiver and direction, in words, and little else.
    EXPECT_LT(bytes.size(), flags.bytes() + 100);
  }
}

TEST(FlagsFile, RefusesWhatIsNotItsOwn) {
  const std::string good = written(someFlags(true));
  EXPECT_EQ(trouble(good, {1, 3}), "room.flags: the flags are those of another scene. Bake again.");
  EXPECT_EQ(trouble(""), "room.flags: too short for visibility flags. Bake again.");
  EXPECT_EQ(trouble(std::string(200, 'x')),
            "room.flags: not a file of visibility flags of this version. Bake again.");
  EXPECT_EQ(trouble(good.substr(0, good.size() - 1)),
            "room.flags: its length does not fit its header. Bake again.");
}

TEST(FlagsFile, SurvivesAnyDamage) {
  const std::string good = written(someFlags(true));
  for (std::size_t i = 0; i < good.size(); i += 7) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x41);
    EXPECT_NE(trouble(bad), "") << i;
  }
}

}  // namespace
}  // namespace soffit::prt
