// SPDX-License-Identifier: MIT
#include "core/io/image/read_image.h"
#include "tests/app/cli/run_program.h"
#include "tests/app/cli/small_room.h"
#include "tests/core/io/project/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace soffit {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Pair;

/// A ball of 1000 lm in free space; the camera sees it 3 m away.
constexpr const char* kBall = R"({"soffit": 1, "name": "Ball", "geometry": [],
  "luminaires": [{"name": "Ball", "shape": {"sphere": 0.5}, "position": [0, 0, 1.6], "flux": 1000}],
  "layouts": [{"name": "Dimmed", "luminaires": {"Ball": {"dimming": 0.5}}}],
  "cameras": [{"name": "Front", "position": [3, 0, 1.6], "target": [0, 0, 1.6], "vertical_fov": 40}]})";

class RenderCommand : public testing::Test {
 protected:
  void SetUp() override { project_ = folder_.write("ball.soffit", kBall).string(); }
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  [[nodiscard]] ProgramResult render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", project_});
    return runSoffit(folder_, arguments);
  }
  /// Expects the one line of an input error that holds the text.
  void expectError(const std::vector<std::string>& arguments, const std::string& text) const {
    const ProgramResult result = render(arguments);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.errorLines(), 1);
    EXPECT_THAT(result.err, HasSubstr(text));
  }
  TemporaryFolder folder_;
  std::string project_;
};

TEST_F(RenderCommand, WritesLuminanceToExr) {
  const auto result =
      render({"-o", at("a.exr"), "--size", "9x9", "--exposure", "3", "--layout", "Dimmed"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto image = io::readImage(at("a.exr"));
  ASSERT_TRUE(image.ok()) << image.error().message();
  EXPECT_EQ(image->width, 9);
  // Flux over pi and area, dimmed, whatever the exposure; single precision.
  const float luminance = 500.0F / (3.14159265F * 3.14159265F);
  EXPECT_NEAR(image->pixels[3 * (4 * 9 + 4)], luminance, 1e-4F * luminance);
  EXPECT_EQ(image->pixels[0], 0.0F);
}

TEST_F(RenderCommand, SaysInTheFileWhatItShows) {
  const auto result = render({"-o", at("a.png"), "--size", "16x12", "--layout", "Dimmed",
                              "--ocio-view", "ACES", "--exposure", "-0.5"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto metadata = io::readMetadata(at("a.png"));
  ASSERT_TRUE(metadata.ok()) << metadata.error().message();
  EXPECT_THAT(*metadata, IsSupersetOf({Pair("Project", "Ball"), Pair("Layout", "Dimmed"),
                                       Pair("Camera", "Front"), Pair("View", "ACES"),
                                       Pair("Exposure", "-0.5 EV")}));
}

TEST_F(RenderCommand, SaysWhatIsWrongBeforeTheLightIsComputed) {
  expectError({"-o", at("a.gif")},
              "a.gif: expected a picture format, found the extension \".gif\"");
  expectError(
      {"-o", at("a.png"), "--size", "640"},
      "--size: expected WIDTHxHEIGHT in pixels, found \"640\". Give for instance 1280x800.");
  expectError(
      {"-o", at("a.png"), "--size", "0x600"},
      "--size: expected 1 to 32768 pixels a side and at most 100 million in all, found 0x600");
  expectError({"-o", at("a.png"), "--camera", "Back"},
              "--camera: the project has no camera \"Back\". It has: Front.");
  expectError({"-o", at("a.png"), "--exposure", "bright"},
              "--exposure: expected stops from -64 to 64 (EV) or \"auto\", found \"bright\". Give "
              "for instance -0.5.");
  expectError({"-o", at("a.png"), "--ocio-view", "Magic"}, "the OCIO config has no view \"Magic\"");
  expectError({"-o", at("a.png"), "--ocio-view", "False colour", "--range", "5,5"},
              "false colour range");
  EXPECT_FALSE(folder_.has("a.png"));
}

TEST_F(RenderCommand, ShowsReflectionsByTheMethodAskedFor) {
  const SmallRoom room;
  const auto mean = [&](const std::string& method) {
    const std::string file = room.at(method + ".exr");
    const auto result = runSoffit(
        room, {"render", room.file(), "-o", file, "--size", "16x10", "--glossy", method, "--set",
               "materials.paint.specular=0.5", "--set", "materials.paint.roughness=0.7"});
    EXPECT_EQ(result.status, 0) << result.err;
    const auto image = io::readImage(file);
    EXPECT_TRUE(image.ok());
    double sum = 0.0;
    for (const float v : image->pixels) sum += static_cast<double>(v);
    return sum;
  };
  const double rays = mean("rays");
  EXPECT_EQ(mean("automatic"), rays);
  EXPECT_LT(mean("none"), 0.75 * rays);
  EXPECT_NEAR(mean("maps"), rays, 0.25 * rays);
  EXPECT_NEAR(mean("harmonics"), rays, 0.25 * rays);
  EXPECT_EQ(render({"-o", at("a.png"), "--glossy", "magic"}).status, 2);
}

TEST_F(RenderCommand, NeedsAnOutput) {
  EXPECT_EQ(render({}).status, 2);
}

}  // namespace
}  // namespace soffit
