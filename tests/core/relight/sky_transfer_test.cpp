// SPDX-License-Identifier: MIT
#include "core/relight/sky_transfer.h"

#include "core/math/rng.h"
#include "core/relight/lighting.h"
#include "core/relight/sensor_readings.h"
#include "core/sh/basis.h"
#include "core/sh/rotation.h"
#include "tests/core/relight/readings.h"
#include "tests/core/relight/window_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::relight::testing {
namespace {

std::shared_ptr<const daylight::Environment> skyOf(const scene::Sky& sky) {
  return std::make_shared<const daylight::Environment>(scene::Environment{"", sky});
}

/// Root mean square of the difference over the area of all surfaces, relative to the mean of b.
double relativeRms(const Planes& a, const Planes& b, const transfer::Operators& op) {
  double area = 0.0;
  double error = 0.0;
  double mean = 0.0;
  for (std::size_t s = 0; s < b[1].size(); ++s) {
    if (op.fill_from[s] != s || op.buried[s] != 0) continue;
    const double w = op.area[s];
    area += w;
    mean += w * double(b[1][s]);
    error += w * std::pow(double(a[1][s]) - double(b[1][s]), 2.0);
  }
  return std::sqrt(error / area) / (mean / area);
}

Planes exactLight(const std::shared_ptr<const daylight::Environment>& environment,
                  const std::vector<light::Luminaire>& luminaires = {}) {
  Lighting lighting(windowSolver(true));
  EXPECT_TRUE(lighting.setLuminaires(luminaires).ok());
  EXPECT_TRUE(lighting.setEnvironment(environment).ok());
  return lighting.total();
}

std::vector<light::Luminaire> panel() {
  light::Luminaire panel;
  panel.name = "P";
  panel.shape = light::Rectangle{0.6, 0.6};
  panel.position = {2.0, 2.5, 2.9};
  panel.flux = 3000.0;
  return {panel};
}

TEST(EvenHarmonics, AreThoseThatDoNotChangeSignWithZ) {
  Rng rng(3);
  for (int bands = 1; bands <= sh::kMaxBands; ++bands) {
    const auto functions = evenHarmonics(bands);
    EXPECT_EQ(functions.size(), static_cast<std::size_t>(bands * (bands + 1) / 2));
    std::array<double, sh::kMaxCoefficients> up{};
    std::array<double, sh::kMaxCoefficients> down{};
    const double z = rng.uniformDouble();
    const double phi = 2.0 * kPi * rng.uniformDouble();
    const double r = std::sqrt(1.0 - z * z);
    sh::evaluate(dvec3(r * std::cos(phi), r * std::sin(phi), z), bands, up);
    sh::evaluate(dvec3(r * std::cos(phi), r * std::sin(phi), -z), bands, down);
    for (const EvenHarmonic& f : functions) {
      const std::size_t k = sh::index(f.l, f.m);
      EXPECT_NEAR(up[k], down[k], 1e-12) << f.l << ' ' << f.m;
      // What keeps the columns from being negative.
      EXPECT_LE(std::abs(up[k]), std::sqrt((2.0 * f.l + 1.0) / (4.0 * kPi)) + 1e-12);
    }
  }
}

TEST(EvenCoefficients, AUniformSkyIsOneNumber) {
  const auto environment =
      skyOf({.cie = 5, .horizontal_illuminance = kPi, .ground_reflectance = 0.5});
  const auto above = evenCoefficients(*environment, 6, true);
  const auto below = evenCoefficients(*environment, 6, false);
  // Radiance 1 and 0.5: times the square root of 4 pi. Truncation: float tables, 1e-6.
  EXPECT_NEAR(above[0].x, std::sqrt(4.0 * kPi), 1e-5);
  EXPECT_NEAR(below[0].x, 0.5 * std::sqrt(4.0 * kPi), 1e-5);
  for (std::size_t k = 1; k < above.size(); ++k) {
    EXPECT_NEAR(above[k].y, 0.0, 1e-5);
    EXPECT_NEAR(below[k].y, 0.0, 1e-5);
  }
}

TEST(EvenCoefficients, TurnedSurroundingsAreTurnedCoefficients) {
  constexpr int kTestBands = 6;
  scene::PatchLight patches;
  patches.scale = 100.0;
  const auto at = [&](double degrees) {
    patches.rotation_deg = degrees;
    const daylight::Environment environment(scene::Environment{"", patches});
    sh::Coefficients all(sh::coefficientCount(kTestBands), 0.0);
    const auto functions = evenHarmonics(kTestBands);
    const auto even = evenCoefficients(environment, kTestBands, true);
    for (std::size_t k = 0; k < even.size(); ++k) {
      all[sh::index(functions[k].l, functions[k].m)] = even[k].x;
    }
    return all;
  };
  const sh::Coefficients before = at(0.0);
  for (const double degrees : {10.0, 77.0, 200.0}) {
    const sh::Coefficients wanted = sh::rotateAboutZ(before, radians(degrees));
    const sh::Coefficients found = at(degrees);
    // Truncation of the rule at the patches' rims (product.md: 1e-4 of the light).
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_NEAR(found[k], wanted[k], 1e-4 * before[0]) << k << " at " << degrees;
    }
  }
}

TEST(SkyTransfer, AUniformSkyOverEvenGroundIsExact) {
  const auto solver = windowSolver(true);
  const auto transfer = SkyTransfer::make(*solver, 3, false, {}, {});
  ASSERT_NE(transfer, nullptr);
  const auto environment =
      skyOf({.cie = 5, .horizontal_illuminance = 10000.0, .ground_reflectance = 0.3});
  Planes mixed;
  spread({}, transfer->mix(*environment), solver->operators(), mixed);
  // Rounding: of the coefficients' tables and single-precision sums.
  EXPECT_LT(relativeRms(mixed, exactLight(environment), solver->operators()), 1e-4);
}

/// The figures of README.md; the printed ones are of the whole range of skies.
TEST(SkyTransfer, TheErrorFallsWithTheBands) {
  const auto solver = windowSolver(true);
  struct Case {
    int cie;
    double azimuth, altitude;
  };
  // The window looks to -y, south: the last has the sun's corona before it.
  const std::array<Case, 5> cases{
      {{1, 0, 45}, {3, 180, 40}, {9, 240, 40}, {12, 0, 50}, {12, 180, 40}}};
  std::vector<std::shared_ptr<const daylight::Environment>> skies;
  std::vector<Planes> exact;
  for (const Case& c : cases) {
    skies.push_back(skyOf({.cie = c.cie,
                           .sun_azimuth_deg = c.azimuth,
                           .sun_altitude_deg = c.altitude,
                           .horizontal_illuminance = 15000.0,
                           .ground_reflectance = 0.2}));
    exact.push_back(exactLight(skies.back()));
  }
  std::array<double, 9> worst{};
  for (const int bands : {2, 3, 4, 5, 6, 8}) {
    const auto transfer = SkyTransfer::make(*solver, bands, false, {}, {});
    for (std::size_t i = 0; i < skies.size(); ++i) {
      Planes mixed;
      spread({}, transfer->mix(*skies[i]), solver->operators(), mixed);
      const double rms = relativeRms(mixed, exact[i], solver->operators());
      printf("  %d bands, CIE %d, sun %.0f/%.0f: %.2f %%\n", bands, cases[i].cie, cases[i].azimuth,
             cases[i].altitude, 100.0 * rms);
      worst[static_cast<std::size_t>(bands)] =
          std::max(worst[static_cast<std::size_t>(bands)], rms);
    }
  }
  // Truncation: bounds stated in README.md.
  EXPECT_LT(worst[4], 0.05);
  EXPECT_LT(worst[6], 0.025);
  EXPECT_LT(worst[8], 0.02);
  EXPECT_LT(worst[8], worst[6]);
  EXPECT_LT(worst[6], worst[4]);
  EXPECT_LT(worst[4], worst[2]);
}

TEST(SkyTransfer, ASliderShowsSkySunAndLuminairesTogether) {
  Lighting lighting(windowSolver(true));
  ASSERT_TRUE(lighting.setLuminaires(panel()).ok());
  const auto environment = skyOf({.cie = 12,
                                  .sun_azimuth_deg = 190.0,
                                  .sun_altitude_deg = 35.0,
                                  .horizontal_illuminance = 12000.0,
                                  .direct_normal_illuminance = 50000.0,
                                  .ground_reflectance = 0.2});
  const auto quick = lighting.totalUnderSky(*environment);
  ASSERT_TRUE(quick.ok());
  const auto solver = windowSolver(true);
  // The sun is exact: what is left is the sky's truncation.
  EXPECT_LT(relativeRms(*quick, exactLight(environment, panel()), solver->operators()), 0.03);
  // A luminaire that is dimmed in between counts.
  lighting.setMix(0, 0.0, dvec3(1.0));
  const auto dark = lighting.totalUnderSky(*environment);
  EXPECT_LT(relativeRms(*dark, exactLight(environment), solver->operators()), 0.03);
}

TEST(SkyTransfer, APictureIsFollowedInColourAboveAndBelow) {
  auto image = std::make_shared<scene::Image>();
  image->width = 64;
  image->height = 32;
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 64; ++column) {
      const float wave = 1.0F + 0.5F * std::sin(0.1F * static_cast<float>(column));
      const float above = row < 16 ? 1.0F : 0.3F;
      image->pixels.insert(image->pixels.end(), {above * wave, above, above * (2.0F - wave)});
    }
  }
  scene::Probe probe{"", scene::ProbeLayout::lat_long, 30.0, 2000.0, image};
  Lighting lighting(windowSolver(true));
  ASSERT_TRUE(lighting.setLuminaires({}).ok());
  const auto& op = windowSolver(true)->operators();
  for (const double turn : {30.0, 120.0}) {
    probe.rotation_deg = turn;
    const auto environment =
        std::make_shared<const daylight::Environment>(scene::Environment{"", probe});
    const auto quick = lighting.totalUnderSky(*environment);
    ASSERT_TRUE(quick.ok());
    const Planes wanted = exactLight(environment);
    for (const std::size_t c : {0U, 1U, 2U}) {
      const Planes a{{(*quick)[c], (*quick)[c], (*quick)[c]}};
      const Planes b{{wanted[c], wanted[c], wanted[c]}};
      EXPECT_LT(relativeRms(a, b, op), 0.03) << "channel " << c << " at " << turn;
    }
  }
}

TEST(SkyTransfer, ItsMakingCanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(SkyTransfer::make(*windowSolver(true), 2, false, {}, Job{nullptr, stop.get_token()}),
            nullptr);
}

TEST(SensorReadings, WhatShinesInIsReadAsByLighting) {
  const auto solver = windowSolver(true);
  const auto sensors = grid({0.3, 0.4, 0.85}, {3.4, 0, 0}, {0, 4.3, 0}, 3, 3);
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(panel()).ok());
  SensorReadings readings(sensors, 24, 1);
  readings.setSolver(solver);
  for (const int cie : {1, 12}) {
    const auto environment = skyOf({.cie = cie,
                                    .sun_azimuth_deg = 170.0,
                                    .sun_altitude_deg = 40.0,
                                    .horizontal_illuminance = 10000.0,
                                    .direct_normal_illuminance = 30000.0,
                                    .ground_reflectance = 0.2});
    ASSERT_TRUE(lighting.setEnvironment(environment).ok());
    const auto wanted = lighting.read(Sensors(*solver, sensors, Quantity::planar, 24, 1));
    const auto found = readings.read(lighting.emitters(), environment);
    ASSERT_TRUE(found.ok());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      // Rounding: sums in another order.
      EXPECT_NEAR((*found)[k].direct.y, wanted[k].direct.y, 1e-4 * wanted[k].direct.y + 1e-6);
      EXPECT_NEAR((*found)[k].indirect.y, wanted[k].indirect.y, 1e-4 * wanted[k].indirect.y);
    }
  }
  const auto dark = readings.read(lighting.emitters());
  EXPECT_LT(
      (*dark)[4].direct.y,
      (*readings.read(lighting.emitters(), skyOf({.cie = 1, .horizontal_illuminance = 1e4})))[4]
          .direct.y);
}

}  // namespace
}  // namespace soffit::relight::testing
