// SPDX-License-Identifier: MIT
#include "core/relight/sky_vectors.h"

#include "core/math/rng.h"
#include "core/relight/lighting.h"
#include "tests/core/relight/window_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::relight::testing {
namespace {

/// Random points: each some slots with weights that sum to one.
struct RandomRows : LightRows {
  std::vector<std::uint32_t> first_of{0};
  std::vector<std::uint32_t> slots_of;
  std::vector<float> weights_of;

  RandomRows(std::size_t points, std::size_t slot_count) {
    Rng rng(11);
    const auto pick = [&](std::size_t n) {
      return static_cast<std::uint32_t>(rng.uniformDouble() * static_cast<double>(n));
    };
    for (std::size_t p = 0; p < points; ++p) {
      const std::uint32_t count = p == 0 ? 0 : 1 + pick(4);
      for (std::uint32_t k = 0; k < count; ++k) {
        slots_of.push_back(pick(slot_count));
        weights_of.push_back(1.0F / static_cast<float>(count));
      }
      first_of.push_back(static_cast<std::uint32_t>(slots_of.size()));
    }
    first = first_of;
    slots = slots_of;
    weights = weights_of;
  }
};

scene::Sky clearSky(double azimuth_deg) {
  return {.cie = 12,
          .sun_azimuth_deg = azimuth_deg,
          .sun_altitude_deg = 35.0,
          .horizontal_illuminance = 12000.0,
          .direct_normal_illuminance = 50000.0,
          .ground_reflectance = 0.2};
}

std::vector<light::Luminaire> panel() {
  light::Luminaire panel;
  panel.name = "P";
  panel.shape = light::Rectangle{0.6, 0.6};
  panel.position = {2.0, 2.5, 2.9};
  panel.flux = 3000.0;
  return {panel};
}

/// Relative to the greatest light: a half's rounding (2^-12 of terms whose sizes sum to some times
/// the light), and light below 0 that is cut off at the texels instead of at the points.
constexpr float kTolerance = 3e-3F;

void expectSameLight(const daylight::Environment& environment, Lighting& lighting,
                     const std::shared_ptr<const LightRows>& rows,
                     std::shared_ptr<const SkyVectors>& vectors) {
  const auto total = lighting.totalUnderSky(environment);
  ASSERT_TRUE(total.ok());
  std::vector<vec3> wanted(rows->points());
  lightPoints(*rows, *total, wanted);
  const auto parts = lighting.partsUnderSky(environment);
  ASSERT_TRUE(parts.ok());
  if (vectors == nullptr || vectors->transfer() != parts->transfer) {
    vectors = SkyVectors::make(parts->transfer, lighting.solver().operators(), rows, {});
  }
  std::vector<vec3> rest(rows->points());
  lightPoints(*rows, *parts->rest, rest);
  std::vector<vec3> found(rows->points());
  vectors->evaluate(parts->weights, rest, found);
  float most = 0.0F;
  float worst = 0.0F;
  for (std::size_t p = 0; p < wanted.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      most = std::max(most, wanted[p][c]);
      worst = std::max(worst, std::abs(wanted[p][c] - found[p][c]));
    }
  }
  printf("  worst %.5f of the greatest light\n", double(worst / most));
  EXPECT_GT(most, 100.0F);
  EXPECT_LT(worst, kTolerance * most);
}

TEST(SkyVectors, TheirSumIsTheLightThatTheTexelsShow) {
  const auto solver = windowSolver(true);
  const auto rows =
      std::make_shared<const RandomRows>(3000, solver->operators().texels.slotCount());
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(panel()).ok());
  std::shared_ptr<const SkyVectors> vectors;
  for (const double azimuth : {0.0, 90.0, 170.0, 190.0, 300.0}) {
    expectSameLight(daylight::Environment(scene::Environment{"", clearSky(azimuth)}), lighting,
                    rows, vectors);
  }
  expectSameLight(
      daylight::Environment(scene::Environment{
          "", scene::Sky{.cie = 1, .horizontal_illuminance = 9000.0, .ground_reflectance = 0.4}}),
      lighting, rows, vectors);
  // 22 functions are 6 groups of four, at 12 halves.
  EXPECT_EQ(vectors->bytes(), rows->points() * 144);
}

TEST(SkyVectors, ColouredSurroundingsAboveAndBelow) {
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
  const auto solver = windowSolver(true);
  const auto rows =
      std::make_shared<const RandomRows>(1000, solver->operators().texels.slotCount());
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires({}).ok());
  std::shared_ptr<const SkyVectors> vectors;
  for (const double turn : {30.0, 200.0}) {
    const scene::Probe probe{"", scene::ProbeLayout::lat_long, turn, 2000.0, image};
    expectSameLight(daylight::Environment(scene::Environment{"", probe}), lighting, rows, vectors);
  }
  EXPECT_EQ(vectors->texelsPerPoint(), 33U);  // 42 functions
}

TEST(SkyVectors, TheRestIsTheSameForAsLongAsNeitherSunNorLuminairesChange) {
  Lighting lighting(windowSolver(true));
  ASSERT_TRUE(lighting.setLuminaires(panel()).ok());
  const auto restOf = [&](const scene::Sky& sky) {
    const auto parts = lighting.partsUnderSky(daylight::Environment(scene::Environment{"", sky}));
    return parts.ok() ? parts->rest : nullptr;
  };
  scene::Sky sky = clearSky(190.0);
  const auto first = restOf(sky);
  ASSERT_NE(first, nullptr);
  sky.ground_reflectance = 0.5;
  EXPECT_EQ(restOf(sky), first);
  sky.sun_azimuth_deg = 195.0;
  const auto turned = restOf(sky);
  EXPECT_NE(turned, first);
  // A sun of half the light: from the same column.
  sky.direct_normal_illuminance *= 0.5;
  const auto paler = restOf(sky);
  Lighting fresh(windowSolver(true));
  ASSERT_TRUE(fresh.setLuminaires(panel()).ok());
  const auto wanted = fresh.partsUnderSky(daylight::Environment(scene::Environment{"", sky}));
  ASSERT_TRUE(wanted.ok());
  EXPECT_EQ(*paler, *wanted->rest);
  lighting.setMix(0, 0.0, dvec3(1.0));
  EXPECT_NE(restOf(sky), paler);
}

TEST(SkyVectors, TheirMakingCanBeCancelled) {
  const auto solver = windowSolver(true);
  const auto transfer = SkyTransfer::make(*solver, 2, false, {}, {});
  ASSERT_NE(transfer, nullptr);
  const auto rows = std::make_shared<const RandomRows>(10, solver->operators().texels.slotCount());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(SkyVectors::make(transfer, solver->operators(), rows, Job{nullptr, stop.get_token()}),
            nullptr);
}

}  // namespace
}  // namespace soffit::relight::testing
