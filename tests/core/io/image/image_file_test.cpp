// SPDX-License-Identifier: MIT
#include "core/color/srgb.h"
#include "core/io/image/memory_file.h"
#include "core/io/image/read_image.h"
#include "core/io/image/write_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>

namespace soffit::io {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("soffit_image_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path at(const std::string& name) const { return folder_ / name; }
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  fs::path folder_;
};

scene::Image ramp(int width, int height, float top) {
  scene::Image image{width, height, 3, {}};
  const int count = width * height * 3;
  for (int i = 0; i < count; ++i)
    image.pixels.push_back(top * static_cast<float>(i) / static_cast<float>(count - 1));
  return image;
}

TEST_F(ImageFile, ExrKeepsEveryFloat) {
  scene::Image image = ramp(7, 5, 123456.0F);
  image.pixels[4] = 1.0e-12F;
  ASSERT_TRUE(writeImage(at("a.exr"), image).ok());
  const auto back = readImage(at("a.exr"));
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->width, 7);
  EXPECT_EQ(back->height, 5);
  EXPECT_EQ(back->pixels, image.pixels);
}

TEST_F(ImageFile, HdrKeepsEightBitsOfTheBrightestChannel) {
  const scene::Image image = ramp(16, 9, 40000.0F);
  ASSERT_TRUE(writeImage(at("a.hdr"), image).ok());
  const auto back = readImage(at("a.hdr"));
  ASSERT_TRUE(back.ok()) << back.error().message();
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::size_t pixel = i / 3 * 3;
    // Shared exponent: 8 bits below the power of two above the brightest channel (the blue one).
    EXPECT_NEAR(back->pixels[i], image.pixels[i], image.pixels[pixel + 2] / 127.0F);
  }
}

TEST_F(ImageFile, CodeValuesComeBackAsStored) {
  scene::Image image{256, 1, 3, {}};
  for (int i = 0; i < 256; ++i)
    for (int c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(i) / 255.0F);
  for (const char* name : {"a.png", "a.tif"}) {
    for (const bool dither : {false, true}) {
      ASSERT_TRUE(writeImage(at(name), image, {.dither = dither}).ok());
      const auto back = readImage(at(name), {.decode_srgb = false});
      ASSERT_TRUE(back.ok()) << back.error().message();
      // Round-off: /255 and back.
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(back->pixels[i], image.pixels[i], 1e-6F);
    }
  }
  ASSERT_TRUE(writeImage(at("a.jpg"), image, {.quality = 100}).ok());
  const auto jpeg = readImage(at("a.jpg"), {.decode_srgb = false});
  // JPEG's own loss on a smooth ramp at quality 100: two code values.
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    EXPECT_NEAR(jpeg->pixels[i], image.pixels[i], 2.5F / 255.0F);
}

TEST_F(ImageFile, SixteenBitsAreFiner) {
  const scene::Image image = ramp(50, 3, 1.0F);
  ASSERT_TRUE(writeImage(at("a.tif"), image, {.bits = 16}).ok());
  const auto back = readImage(at("a.tif"), {.decode_srgb = false});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_NEAR(back->pixels[i], image.pixels[i], 0.51F / 65535.0F);  // half a code value
  }
}

TEST_F(ImageFile, DitherKeepsTheMean) {
  scene::Image image{64, 64, 3, std::vector<float>(std::size_t{64} * 64 * 3, 100.3F / 255.0F)};
  ASSERT_TRUE(writeImage(at("a.png"), image, {.dither = true}).ok());
  const auto back = readImage(at("a.png"), {.decode_srgb = false});
  double sum = 0;
  for (const float v : back->pixels) sum += static_cast<double>(v) * 255.0;
  // 100 without dither. The noise is low-discrepancy: its mean over 64 x 64 is good to 0.02.
  EXPECT_NEAR(sum / static_cast<double>(back->pixels.size()), 100.3, 0.02);
}

TEST_F(ImageFile, TexturesAreDecodedToLinear) {
  const scene::Image image{2, 1, 3, {0.0F, 0.5F, 1.0F, 0.2F, 0.4F, 0.6F}};
  ASSERT_TRUE(writeImage(at("a.tif"), image, {.bits = 16}).ok());
  const auto back = readImage(at("a.tif"));
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(back->pixels[i], color::srgbDecode(image.pixels[i]), 1e-4F);
}

TEST_F(ImageFile, GreyFillsThreeChannels) {
  ASSERT_TRUE(writeImage(at("grey.png"), scene::Image{2, 1, 1, {0.2F, 0.6F}}).ok());
  const auto back = readImage(at("grey.png"), {.decode_srgb = false});
  EXPECT_EQ(back->channels, 3);
  const float a = 51.0F / 255.0F;
  const float b = 153.0F / 255.0F;
  EXPECT_THAT(back->pixels, testing::Pointwise(testing::FloatEq(), {a, a, a, b, b, b}));
}

TEST_F(ImageFile, WhatIsNoNumberIsWrittenAsBlackAndReadAsNought) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const scene::Image image{1, 1, 3, {kNan, kInf, -kInf}};
  ASSERT_TRUE(writeImage(at("a.png"), image).ok());
  EXPECT_THAT(readImage(at("a.png"))->pixels, ElementsAre(0.0F, 1.0F, 0.0F));
  ASSERT_TRUE(writeImage(at("a.exr"), image).ok());
  EXPECT_THAT(readImage(at("a.exr"))->pixels, ElementsAre(0.0F, 0.0F, 0.0F));
}

TEST_F(ImageFile, MetadataComeBackFromEveryFormat) {
  const Metadata metadata{{"Project", "Büro: Nord"},
                          {"Layout", "As planned; x=1"},
                          {"Exposure", "-1.5 EV"},
                          {"Notes", "two\nlines"}};
  for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
    ASSERT_TRUE(writeImage(at(name), ramp(8, 8, 1.0F), {.metadata = metadata}).ok());
    const auto back = readMetadata(at(name));
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_THAT(*back, ElementsAre(Pair("Software", HasSubstr("Soffit 0.")),
                                   Pair("Project", "Büro: Nord"), Pair("Layout", "As planned; x=1"),
                                   Pair("Exposure", "-1.5 EV"), Pair("Notes", "two lines")))
        << name;
  }
  ASSERT_TRUE(writeImage(at("a.hdr"), ramp(8, 8, 1.0F), {.metadata = metadata}).ok());
  EXPECT_THAT(*readMetadata(at("a.hdr")),
              ElementsAre(Pair("SOFTWARE", HasSubstr("Soffit 0.")), Pair("Project", "Büro: Nord"),
                          Pair("Layout", "As planned; x=1"), Pair("Exposure", "-1.5 EV"),
                          Pair("Notes", "two lines")));
}

TEST_F(ImageFile, IsWrittenWholeOrNotAtAll) {
  ASSERT_TRUE(writeImage(at("a.png"), ramp(4, 4, 1.0F)).ok());
  EXPECT_THAT(listing(), ElementsAre("a.png"));  // no temporary is left
  fs::create_directory(at("b.png"));
  const auto failed = writeImage(at("b.png"), ramp(4, 4, 1.0F));
  ASSERT_FALSE(failed.ok());
  EXPECT_THAT(failed.error().message(), HasSubstr("b.png: the picture cannot be put in place"));
  EXPECT_THAT(listing(), ElementsAre("a.png", "b.png"));
}

TEST_F(ImageFile, WritingSaysWhatIsWrong) {
  EXPECT_EQ(
      writeImage("a.gif", ramp(4, 4, 1.0F)).error().message(),
      "a.gif: expected a picture format, found the extension \".gif\". Use .png, .jpg or .tif for "
      "tone-mapped pictures, .exr or .hdr for luminances.");
  EXPECT_EQ(writeImage("a.png", scene::Image{}).error().message(),
            "a.png: the picture has no pixels. Ask for at least 1 x 1 pixel.");
  EXPECT_THAT(writeImage("/nowhere/at/all/a.png", ramp(4, 4, 1.0F)).error().message(),
              HasSubstr("/nowhere/at/all/a.png: the picture cannot be written ("));
}

TEST_F(ImageFile, ReadingSaysWhatIsWrong) {
  EXPECT_EQ(
      readImage("/nowhere/a.png").error().message(),
      "/nowhere/a.png: the picture does not exist. Check the path; it is relative to the project.");
  std::ofstream(at("text.png")) << "this is no picture";
  EXPECT_THAT(readImage(at("text.png")).error().message(),
              HasSubstr("text.png: the picture cannot be read ("));
  ASSERT_TRUE(writeImage(at("a.png"), ramp(64, 64, 1.0F)).ok());
  EXPECT_THAT(
      readImage(at("a.png"), {.max_pixels = 1000}).error().message(),
      HasSubstr("a.png: the picture has 64 x 64 pixels, the limit is 1000 in all. Scale it down."));
  fs::resize_file(at("a.png"), fs::file_size(at("a.png")) / 2);
  EXPECT_FALSE(readImage(at("a.png")).ok());
  std::ofstream(at("text.hdr")) << "no radiance";
  EXPECT_FALSE(readMetadata(at("text.hdr")).ok());
}

TEST(SceneLinear, IsToldByTheExtension) {
  EXPECT_TRUE(isSceneLinear("a.EXR"));
  EXPECT_TRUE(isSceneLinear("a.hdr"));
  EXPECT_FALSE(isSceneLinear("a.png"));
}

/// As on a full disk: no file may grow beyond a few kilobytes while it lives.
class NoRoom {
 public:
  NoRoom() {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit few{4096, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &few);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~NoRoom() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(ImageFile, AFullDiskIsAnErrorAndLeavesNothing) {
  // Not JPEG: libjpeg ends the program when it cannot write. It writes to memory, which has room on
  // a full disk; here the limit holds for both.
  // Noise, so that no compression makes it fit.
  scene::Image image{96, 96, 3, {}};
  std::uint32_t state = 1;
  for (int i = 0; i < 96 * 96 * 3; ++i) {
    state = state * 1664525U + 1013904223U;
    image.pixels.push_back(static_cast<float>(state >> 8U) / 16777216.0F);
  }
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.hdr"}) {
    const NoRoom full;
    const auto written = writeImage(at(name), image);
    ASSERT_FALSE(written) << name;
    EXPECT_THAT(written.error().message(), HasSubstr("cannot be written")) << name;
  }
  EXPECT_THAT(listing(), testing::IsEmpty());
}

TEST_F(ImageFile, CopyingFromMemoryNoticesAFullDisk) {
  const MemoryFile memory;
  std::ofstream(memory.path(), std::ios::binary) << std::string(10000, 'x');
  EXPECT_TRUE(memory.endsWith("xxx"));
  EXPECT_FALSE(memory.endsWith("xyx"));
  {
    const NoRoom full;
    EXPECT_EQ(memory.copyTo(at("a")), EFBIG);
  }
  EXPECT_THAT(listing(), testing::IsEmpty());
  EXPECT_EQ(memory.copyTo(at("a")), 0);
  EXPECT_EQ(fs::file_size(at("a")), 10000U);
  EXPECT_EQ(memory.copyTo(at("a")), EEXIST);
  EXPECT_EQ(fs::file_size(at("a")), 10000U) << "another's file stays";
}

}  // namespace
}  // namespace soffit::io
