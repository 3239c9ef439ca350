// SPDX-License-Identifier: MIT
// Slips of the hand: each ends in one line that says what, where and the remedy, and in nothing
// half written.
#include "tests/app/cli/run_program.h"
#include "tests/app/cli/small_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <string>
#include <thread>
#include <vector>

namespace soffit {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Slip {
  std::vector<std::string> words;
  int status;
  const char* says;
};

void expectRefusal(const SmallRoom& room, const Slip& slip) {
  const auto files = room.count();
  const auto result = runSoffit(room, slip.words);
  EXPECT_EQ(result.status, slip.status) << result.err;
  EXPECT_EQ(result.errorLines(), 1) << result.err;
  EXPECT_THAT(result.err, StartsWith("soffit: "));
  EXPECT_THAT(result.err, HasSubstr(slip.says));
  EXPECT_EQ(result.out, "");
  // The program's own output and errors are files of that folder as well.
  EXPECT_LE(room.count(), files + 2) << result.err;
}

TEST(BadInput, Pictures) {
  const SmallRoom room;
  const auto render = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"render", room.file(), "-o", room.at("x.png")};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  for (const Slip& slip : std::vector<Slip>{
           {render({"--size", "100000x10"}), 1, "--size: expected 1 to 32768 pixels"},
           {render({"--size", "32768x32768"}), 1, "at most 100 million in all"},
           {render({"--size", "0x10"}), 1, "found 0x10"},
           {render({"--size", "big"}), 1, "expected WIDTHxHEIGHT"},
           {render({"--width", "100000"}), 2, "--width"},
           {render({"--exposure", "nan"}), 1, "expected stops from -64 to 64"},
           {render({"--exposure", "1e6"}), 1, "expected stops from -64 to 64"},
           {render({"--camera", "Nobody"}), 1, "It has: Door"},
           {render({"--layout", "None"}), 1, "Choose one of: Both, Panel alone"},
           {render({"--ocio-view", "None"}), 1, "has no view"},
           {render({"--set", "cameras.Door.position=1e30,0,0"}), 1, "within 1e+07 m"},
           {render({"--set", "cameras.Door.target=0.3,0.3,1.6"}), 1, "where the camera stands"},
           {{"render", room.file(), "-o", room.at("none/x.png")}, 1, "there is no folder"},
           {{"render", room.file(), "-o", room.at("x.gif")}, 1, "expected a picture format"}}) {
    expectRefusal(room, slip);
  }
}

TEST(BadInput, NumbersAndNames) {
  const SmallRoom room;
  const auto measure = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"measure", room.file()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  room.write("nan.csv", "x,y,z\n1,2,nan\n");
  room.write("far.csv", "x,y,z\n1,2,1e30\n");
  const auto move = [&](const char* lamp, const char* path) {
    return std::vector<std::string>{"move", room.file(), "--luminaire",
                                    lamp,   "--path",    room.at(path)};
  };
  for (const Slip& slip : std::vector<Slip>{
           {measure({"--set", "luminaires.Panel.flux=-5"}), 1, "luminaires.Panel.flux: "},
           {measure({"--set", "luminaires.Panel.flux=nan"}), 1, "expected a finite number"},
           {measure({"--set", "luminaires.Pannel.flux=5"}), 1, "There is: Panel, Lamp"},
           {measure({"--set", "luminaires.Panel.position=1e9,0,0"}), 1, "within 1e+07 m"},
           {measure({"--set", "materials.paint.diffuse=1.2,1,1"}), 1, "from 0 to 1, found 1.2"},
           {measure({"--set", "materials.paint.specular=0.7"}), 1, "more than 1"},
           {measure({"--set", "work_planes.Desk.u=0,0,0"}), 1, "span no area"},
           {measure({"--set", "quality.texels=5"}), 1, "room.soffit: quality.texels: expected"},
           {measure({"--seed", "-1"}), 2, "expected a whole number from 0, found -1"},
           {measure({"--sensors", room.at("none.csv")}), 1, "there is no such file"},
           {measure({"--sensors", room.at("nan.csv")}), 1, "expected the header"},
           {move("Panel", "nan.csv"), 1, "nan.csv:2: expected a finite number"},
           {move("Panel", "far.csv"), 1, "far.csv:2: expected numbers up to 1e+07"},
           {move("Pannel", "path.csv"), 1, "It has: Panel, Lamp"},
           {{"verify", room.file(), "--time-limit", "0"}, 2, "expected a number above 0, found 0"},
           {{"verify", room.file(), "--path", room.at("path.csv")}, 1, "--luminaire"},
           {{"compare", room.file(), "--layouts", "Both,None"}, 1, "there is no layout"},
           {{"bench", room.at("none"), "-o", room.at("b")}, 1, "there is no such project"},
           {{"import", room.at("room.obj"), "-o", room.at("p.soffit"), "--unit", "0"},
            2,
            "expected a number above 0, found 0"}}) {
    expectRefusal(room, slip);
  }
}

TEST(BadInput, ABlackPictureIsToldAbout) {
  const SmallRoom room;
  const auto result =
      runSoffit(room, {"render", room.file(), "-o", room.at("x.png"), "--size", "16x10", "--set",
                       "luminaires.Panel.on=false", "--set", "luminaires.Lamp.on=false"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("the picture is black"));
  EXPECT_TRUE(room.has("x.png"));
}

TEST(BadInput, AnInterruptedBakeLeavesNothing) {
  const SmallRoom room;
  // Fine enough to be at work for minutes.
  std::vector<std::string> words{SOFFIT_PROGRAM, "bake", room.file(), "--set",
                                 "quality.texels=2000000"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  ASSERT_EQ(posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ), 0);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  int state = 0;
  ASSERT_EQ(::waitpid(child, &state, 0), child);
  // As every program that Ctrl-C ends, so that a shell's loop ends with it.
  EXPECT_TRUE(WIFSIGNALED(state));
  EXPECT_EQ(WTERMSIG(state), SIGINT);
  EXPECT_FALSE(room.has("cache")) << "nothing is stored";
}

}  // namespace
}  // namespace soffit
