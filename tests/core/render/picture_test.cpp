// SPDX-License-Identifier: MIT
#include "core/render/picture.h"

#include "core/render/legend.h"
#include "core/render/pen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace soffit::render {
namespace {

using testing::ElementsAre;
using testing::Pair;

const std::filesystem::path kConfig =
    std::filesystem::path(SOFFIT_SOURCE_DIR) / "resources/ocio/config.ocio";

Film evenFilm(int width, int height, float cd, float lux) {
  Film film(width, height);
  for (std::size_t i = 0; i < film.count(); ++i) {
    film.radiance[i] = vec3(cd);
    film.lux[i] = lux;
    film.surface[i] = 1.0F;
  }
  return film;
}

vec3 pixel(const scene::Image& image, int x, int y) {
  const auto at = static_cast<std::size_t>((y * image.width + x) * 3);
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

PictureOptions options(const char* view) {
  PictureOptions o;
  o.display.config = kConfig;
  o.display.view = view;
  return o;
}

TEST(DevelopPicture, PutsMidGreyWhereTheViewHasIt) {
  PictureOptions o = options("Filmic");
  o.exposure_ev = 1.0;
  const auto image = developPicture(evenFilm(4, 3, 9.0F, 0.0F), o).value();
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.height, 3);
  EXPECT_NEAR(pixel(image, 2, 1).y, 0.461F, 6e-4F);  // printed to three digits
}

TEST(DevelopPicture, FalseColourShowsLuxWhateverTheExposure) {
  PictureOptions o = options("False colour");
  o.range = color::FalseColorRange{0, 1000, false};
  o.legend = false;
  const Film film = evenFilm(4, 3, 9.0F, 300.0F);
  const auto image = developPicture(film, o).value();
  EXPECT_EQ(pixel(image, 1, 1), color::falseColorAt(0.3F));
  o.exposure_ev = 5.0;
  EXPECT_EQ(developPicture(film, o).value().pixels, image.pixels);
}

TEST(DevelopPicture, FalseColourShowsLuminairesWhiteAndNothingDark) {
  PictureOptions o = options("False colour");
  Film film(2, 1);
  film.lamp[0] = 1.0F;
  const auto image = developPicture(film, o).value();
  EXPECT_GT(pixel(image, 0, 0).x, 0.9F);
  EXPECT_LT(pixel(image, 1, 0).x, 0.2F);
}

TEST(DevelopPicture, PrintsLegendAndTitle) {
  PictureOptions o = options("False colour");
  const Film film = evenFilm(400, 300, 9.0F, 300.0F);
  const auto with = developPicture(film, o).value();
  o.legend = false;
  const auto without = developPicture(film, o).value();
  o.title = "Layout A";
  const auto titled = developPicture(film, o).value();
  EXPECT_NE(with.pixels, without.pixels);
  EXPECT_NE(titled.pixels, without.pixels);
  // The legend keeps to the right quarter, the title to the lower left.
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) ASSERT_EQ(pixel(with, x, y), pixel(without, x, y));
    if (y < 250) {
      ASSERT_EQ(pixel(titled, 20, y), pixel(without, 20, y));
    }
  }
}

TEST(DevelopPicture, SaysWhatIsWrong) {
  EXPECT_FALSE(developPicture(evenFilm(2, 2, 1, 1), options("No such view")).ok());
  PictureOptions o = options("False colour");
  o.range = color::FalseColorRange{5, 5, false};
  EXPECT_FALSE(developPicture(evenFilm(2, 2, 1, 1), o).ok());
}

TEST(FittingRange, IgnoresTheBrightestTwoPercentAndWhatIsNoSurface) {
  Film film = evenFilm(100, 10, 1.0F, 400.0F);
  for (std::size_t i = 0; i < 15; ++i) film.lux[i] = 50000.0F;
  for (std::size_t i = 500; i < 700; ++i) {
    film.surface[i] = 0.0F;
    film.lux[i] = 9000.0F;
  }
  EXPECT_EQ(fittingRange(film).max, 500.0);
  EXPECT_EQ(fittingRange(Film(3, 3)).max, 1.0);
}

TEST(LinearPicture, IsTheFilm) {
  const auto image = linearPicture(evenFilm(3, 2, 12345.0F, 0.0F));
  EXPECT_EQ(image.channels, 3);
  EXPECT_THAT(image.pixels, testing::Each(12345.0F));
}

TEST(PictureMetadata, SaysWhatThePictureShows) {
  const PictureFacts facts{.project = "Office",
                           .layout = "As planned",
                           .camera = "Entrance",
                           .view = "Filmic",
                           .exposure_ev = -0.5};
  EXPECT_THAT(
      pictureMetadata(facts, false),
      ElementsAre(Pair("Project", "Office"), Pair("Layout", "As planned"),
                  Pair("Camera", "Entrance"), Pair("View", "Filmic"), Pair("Exposure", "-0.5 EV")));
  EXPECT_THAT(pictureMetadata(facts, true),
              ElementsAre(Pair("Project", "Office"), Pair("Layout", "As planned"),
                          Pair("Camera", "Entrance"), Pair("Unit", "cd/m2")));
  EXPECT_THAT(pictureMetadata({.project = "A", .view = "ACES"}, false),
              ElementsAre(Pair("Project", "A"), Pair("View", "ACES"), Pair("Exposure", "0 EV")));
  EXPECT_THAT(pictureMetadata({.view = "ACES", .white_balance = 4000.0}, false),
              ElementsAre(Pair("View", "ACES"), Pair("Exposure", "0 EV"),
                          Pair("White balance", "4000 K")));
}

TEST(Pen, CutsOffWhatLiesOutside) {
  scene::Image image{10, 10, 3, std::vector<float>(300, 0.5F)};
  drawLine(image, {-50, 5}, {60, 5}, 2.0F, vec3(1.0F));
  EXPECT_EQ(pixel(image, 0, 4), vec3(1.0F));
  EXPECT_EQ(pixel(image, 9, 5), vec3(1.0F));
  EXPECT_EQ(pixel(image, 5, 7), vec3(0.5F));
  fillRounded(image, {-5, -5, 3, 3}, 0.0F, vec3(0.0F), 1.0F);
  EXPECT_EQ(pixel(image, 2, 2), vec3(0.0F));
  drawText(image, {8, 200}, 9.0F, "outside", vec3(1.0F));
  drawLegend(image, color::FalseColorRange{});  // too small: nothing happens
  EXPECT_EQ(pixel(image, 5, 8), vec3(0.5F));
}

TEST(Pen, CoversPixelsByTheirShare) {
  scene::Image image{4, 1, 3, std::vector<float>(12, 0.0F)};
  fillRounded(image, {0.0F, -10, 2.5F, 10}, 0.0F, vec3(1.0F), 1.0F);
  EXPECT_NEAR(pixel(image, 1, 0).x, 1.0F, 1e-6F);
  EXPECT_NEAR(pixel(image, 2, 0).x, 0.5F, 1e-6F);
  EXPECT_NEAR(pixel(image, 3, 0).x, 0.0F, 1e-6F);
}

}  // namespace
}  // namespace soffit::render
