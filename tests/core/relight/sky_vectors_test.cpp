// SPDX-License-Identifier: MIT
#include "core/relight/sky_vectors.h"

#include "core/relight/lighting.h"
#include "tests/core/relight/window_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::relight::testing {
namespace {

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

/// Relative to the greatest light: halves, 2^-11 of terms whose sizes sum to some times the light.
constexpr float kTolerance = 2e-3F;

void expectSameLight(const daylight::Environment& environment, Lighting& lighting,
                     std::shared_ptr<const SkyVectors>& vectors) {
  const auto wanted = lighting.totalUnderSky(environment);
  ASSERT_TRUE(wanted.ok());
  const auto parts = lighting.partsUnderSky(environment);
  ASSERT_TRUE(parts.ok());
  if (vectors == nullptr || vectors->transfer() != parts->transfer) {
    vectors = SkyVectors::make(parts->transfer, lighting.solver().operators(), {});
  }
  const Planes found = vectors->evaluate(parts->weights, *parts->rest);
  float most = 0.0F;
  float worst = 0.0F;
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_EQ(found[c].size(), (*wanted)[c].size());
    for (std::size_t s = 0; s < found[c].size(); ++s) {
      EXPECT_GE(found[c][s], 0.0F);
      most = std::max(most, (*wanted)[c][s]);
      worst = std::max(worst, std::abs((*wanted)[c][s] - found[c][s]));
    }
  }
  printf("  worst %.6f of the greatest light\n", static_cast<double>(worst / most));
  EXPECT_GT(most, 100.0F);
  EXPECT_LT(worst, kTolerance * most);
}

TEST(SkyVectors, TheirSumIsTheLightThatTheTexelsShow) {
  const auto solver = windowSolver(true);
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(panel()).ok());
  std::shared_ptr<const SkyVectors> vectors;
  for (const double azimuth : {0.0, 90.0, 170.0, 190.0, 300.0}) {
    expectSameLight(daylight::Environment(scene::Environment{"", clearSky(azimuth)}), lighting,
                    vectors);
  }
  expectSameLight(
      daylight::Environment(scene::Environment{
          "", scene::Sky{.cie = 1, .horizontal_illuminance = 9000.0, .ground_reflectance = 0.4}}),
      lighting, vectors);
  // 22 functions are 6 groups of four, at 16 halves.
  EXPECT_EQ(vectors->bytes(), vectors->slots() * 192);
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
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires({}).ok());
  std::shared_ptr<const SkyVectors> vectors;
  for (const double turn : {30.0, 200.0}) {
    const scene::Probe probe{"", scene::ProbeLayout::lat_long, turn, 2000.0, image};
    expectSameLight(daylight::Environment(scene::Environment{"", probe}), lighting, vectors);
  }
  EXPECT_EQ(vectors->groups(), 11U);  // 42 functions
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
  ASSERT_EQ(paler->size(), wanted->rest->size());
  for (std::size_t k = 0; k < paler->size(); ++k) {
    EXPECT_EQ((*paler)[k].direct, (*wanted->rest)[k].direct);
    EXPECT_EQ((*paler)[k].reflected, (*wanted->rest)[k].reflected);
  }
  lighting.setMix(0, 0.0, dvec3(1.0));
  EXPECT_NE(restOf(sky), paler);
}

TEST(SkyVectors, TheirMakingCanBeCancelled) {
  const auto solver = windowSolver(true);
  const auto transfer = SkyTransfer::make(*solver, 2, false, {}, {});
  ASSERT_NE(transfer, nullptr);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(SkyVectors::make(transfer, solver->operators(), Job{nullptr, stop.get_token()}),
            nullptr);
}

}  // namespace
}  // namespace soffit::relight::testing
