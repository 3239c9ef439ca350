// SPDX-License-Identifier: MIT
#include "core/daylight/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::daylight {
namespace {

scene::Environment skyOf(scene::Sky sky) {
  return {"", sky};
}

/// Six colours on the axes, blended by the squares of the direction's coordinates.
dvec3 sixSides(const dvec3& d) {
  constexpr std::array<dvec3, 6> kColors{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1),
                                         dvec3(1, 1, 0), dvec3(0, 1, 1), dvec3(1, 0, 1)};
  const dvec3 squares = d * d;
  dvec3 sum(0.0);
  for (int k = 0; k < 3; ++k) {
    sum += squares[k] * kColors[static_cast<std::size_t>(d[k] >= 0.0 ? 2 * k : 2 * k + 1)];
  }
  return sum;
}

std::shared_ptr<const scene::Image> painted(sh::EnvironmentLayout layout, int width, int height) {
  auto image = std::make_shared<scene::Image>();
  image->width = width;
  image->height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto d = sh::environmentDirection(layout, {(x + 0.5) / width, (y + 0.5) / height});
      const dvec3 color = d ? sixSides(*d) : dvec3(0.0);
      for (int c = 0; c < 3; ++c) image->pixels.push_back(static_cast<float>(color[c]));
    }
  }
  return image;
}

struct Layout {
  scene::ProbeLayout kind;
  sh::EnvironmentLayout layout;
  int width, height;
};
constexpr std::array<Layout, 4> kLayouts{
    Layout{scene::ProbeLayout::lat_long, sh::EnvironmentLayout::lat_long, 256, 128},
    Layout{scene::ProbeLayout::angular, sh::EnvironmentLayout::angular_map, 256, 256},
    Layout{scene::ProbeLayout::cross, sh::EnvironmentLayout::horizontal_cross, 256, 192},
    Layout{scene::ProbeLayout::cross, sh::EnvironmentLayout::vertical_cross, 192, 256}};

Environment probe(const Layout& l, double rotation_deg, double scale) {
  return Environment({"", scene::Probe{"p.hdr", l.kind, rotation_deg, scale,
                                       painted(l.layout, l.width, l.height)}});
}

TEST(Environment, PicturesShowTheirSixAxes) {
  constexpr std::array<dvec3, 6> kAxes{dvec3(1, 0, 0),  dvec3(-1, 0, 0), dvec3(0, 1, 0),
                                       dvec3(0, -1, 0), dvec3(0, 0, 1),  dvec3(0, 0, -1)};
  for (const Layout& l : kLayouts) {
    const Environment e = probe(l, 0.0, 100.0);
    for (const dvec3& axis : kAxes) {
      // Truncation: half a pixel of a picture of some 1.4 degrees a pixel.
      EXPECT_LT(glm::length(e.radiance(axis) - 100.0 * sixSides(axis)), 100.0 * 0.05);
      EXPECT_LT(glm::length(e.smoothRadiance(axis) - 100.0 * sixSides(axis)), 100.0 * 0.1);
    }
  }
}

TEST(Environment, RotationTurnsAPictureCounterClockwise) {
  const Environment e = probe(kLayouts[0], 90.0, 1.0);
  // What was on +x is on +y now, what was on +y on -x.
  EXPECT_LT(glm::length(e.radiance({0, 1, 0}) - sixSides({1, 0, 0})), 0.05);
  EXPECT_LT(glm::length(e.radiance({-1, 0, 0}) - sixSides({0, 1, 0})), 0.05);
  EXPECT_LT(glm::length(e.smoothRadiance({-1, 0, 0}) - sixSides({0, 1, 0})), 0.1);
}

TEST(Environment, ThreeLayoutsOfOneLightGiveOneIlluminance) {
  std::vector<dvec3> found;
  for (const Layout& l : kLayouts) {
    const Environment e = probe(l, 30.0, 1.0);
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < SkyTable::kCells; ++i) {
      const dvec3 d = SkyTable::direction(i, {0.5, 0.5});
      sum += e.smoothRadiance(d) * std::max(0.0, d.z) * (4.0 * kPi / SkyTable::kCells);
    }
    found.push_back(sum);
  }
  for (const dvec3& f : found) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], found[0][c], 0.01 * found[0][c]);
  }
}

TEST(Environment, ABrightSpotOfAPictureBecomesADisc) {
  auto image = std::make_shared<scene::Image>();
  image->width = 512;
  image->height = 256;
  image->pixels.assign(std::size_t{3} * 512 * 256, 1.0F);
  // Two pixels square about azimuth 0 (the centre), 60 degrees up.
  const int row = 256 / 2 - 256 / 3;
  for (int y = row; y < row + 2; ++y) {
    for (int x = 255; x < 257; ++x) {
      for (int c = 0; c < 3; ++c)
        image->pixels[static_cast<std::size_t>(3 * (y * 512 + x) + c)] = 1e5F;
    }
  }
  const Environment e({"", scene::Probe{"p", scene::ProbeLayout::lat_long, 0.0, 1.0, image}});
  ASSERT_EQ(e.spots().size(), 1U);
  const Spot& spot = e.spots()[0];
  const dvec3 wanted = skyDirection(0.0, 0.5 * kPi - kPi * (row + 1) / 256.0);
  EXPECT_GT(glm::dot(spot.direction, wanted), std::cos(radians(0.1)));
  const double angle =
      2.0 * kPi / 256.0 * (std::cos(kPi * row / 256.0) - std::cos(kPi * (row + 2) / 256.0));
  EXPECT_NEAR(spot.normal_illuminance.y, 1e5 * angle, 1e-6 * 1e5);
  EXPECT_NEAR(e.smoothRadiance(wanted).y, 1.0, 1.0) << "the disc is not counted twice";
  EXPECT_GT(e.radiance(wanted).y, 5e4) << "the eye sees it";
  EXPECT_GT(e.table().density(wanted), 10.0 / (4.0 * kPi)) << "and it is sampled";
}

TEST(Environment, APictureThatIsTakenOverTurnsAndScalesAsANewOne) {
  auto image = std::make_shared<scene::Image>();
  image->width = 128;
  image->height = 64;
  for (int i = 0; i < 3 * 128 * 64; ++i) {
    image->pixels.push_back(i >= 3 * 1000 && i < 3 * 1002 ? 5e4F : 1.0F + 0.01F * float(i % 97));
  }
  const auto at = [&](double rotation, double scale, const Environment* like) {
    return Environment(
        {"", scene::Probe{"p", scene::ProbeLayout::lat_long, rotation, scale, image}}, like);
  };
  const Environment first = at(10.0, 1.0, nullptr);
  const Environment again = at(75.0, 20.0, &first);
  const Environment wanted = at(75.0, 20.0, nullptr);
  ASSERT_EQ(again.spots().size(), wanted.spots().size());
  ASSERT_EQ(again.spots().size(), 1U);
  EXPECT_LT(glm::length(again.spots()[0].direction - wanted.spots()[0].direction), 1e-12);
  const double e = wanted.spots()[0].normal_illuminance.y;
  EXPECT_NEAR(again.spots()[0].normal_illuminance.y, e, 1e-9 * e);
  for (std::size_t i = 0; i < SkyTable::kCells; i += 37) {
    const dvec3 d = SkyTable::direction(i, {0.3, 0.6});
    EXPECT_LT(glm::length(again.smoothRadiance(d) - wanted.smoothRadiance(d)), 1e-6);
    EXPECT_LT(glm::length(again.radiance(d) - wanted.radiance(d)), 1e-6);
  }
  EXPECT_FALSE(again.dark());
  EXPECT_TRUE(at(0.0, 0.0, &first).dark());
  EXPECT_FALSE(at(0.0, 1.0, &wanted).dark());
}

TEST(Environment, TheSunsDiscGivesItsNormalIlluminance) {
  const Environment e(skyOf({.cie = 12,
                             .sun_azimuth_deg = 90.0,
                             .sun_altitude_deg = 30.0,
                             .horizontal_illuminance = 1.0,
                             .direct_normal_illuminance = 80000.0}));
  ASSERT_TRUE(e.sun());
  EXPECT_NEAR(e.sun()->radiance() * kPi * std::pow(std::sin(Sun::kRadius), 2.0), 80000.0, 1e-6);
  EXPECT_NEAR(e.sun()->direction.x, std::cos(radians(30.0)), 1e-15);
  EXPECT_TRUE(e.sun()->covers(skyDirection(radians(90.0), radians(30.0) + 0.99 * Sun::kRadius)));
  EXPECT_FALSE(e.sun()->covers(skyDirection(radians(90.0), radians(30.0) + 1.01 * Sun::kRadius)));
}

TEST(Environment, ASunBelowTheHorizonHasNoDisc) {
  const Environment e(skyOf({.cie = 3,
                             .sun_altitude_deg = -2.0,
                             .horizontal_illuminance = 1.0,
                             .direct_normal_illuminance = 80000.0}));
  EXPECT_FALSE(e.sun());
  EXPECT_FALSE(e.dark());
  EXPECT_TRUE(Environment(skyOf({.cie = 3})).dark()) << "0 lx";
}

TEST(Environment, TheGroundReflectsTheHorizontalIlluminance) {
  const Environment e(
      skyOf({.cie = 5, .horizontal_illuminance = 1000.0, .ground_reflectance = 0.2}));
  EXPECT_NEAR(e.radiance({0.6, 0, -0.8}).x, 200.0 / kPi, 1e-12);
  EXPECT_NEAR(e.radiance({1, 0, 0}).x, 1000.0 / kPi, 1e-9);
}

TEST(Environment, TheTutorialsLightIsTurned) {
  scene::PatchLight light;
  light.scale = 50.0;
  const Environment e({"", light});
  EXPECT_NEAR(e.radiance({0, 0, 1}).x, 50.0, 1e-12);
  EXPECT_NEAR(e.radiance({std::cos(2.5), std::sin(2.5), 0}).x, 50.0, 1e-12);
  light.rotation_deg = 90.0;
  const Environment turned({"", light});
  EXPECT_NEAR(turned.radiance({-std::sin(2.5), std::cos(2.5), 0}).x, 50.0, 1e-12);
}

}  // namespace
}  // namespace soffit::daylight
