// SPDX-License-Identifier: MIT
#include "core/render/quick_reflections.h"

#include "core/render/view_renderer.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265F;

double seen(const ViewScene& scene, Reflections method, bool quick = false) {
  RenderOptions o;
  o.width = o.height = 24;
  o.reflections = method;
  o.quick = quick;
  const scene::Camera camera{"A", {0, -2, 3}, {0, 0, 0}, 4.0};
  const auto film = renderView(scene, camera, EvenLight(vec3(100 * kPiF)), o).value();
  double sum = 0.0;
  for (const vec3& p : film.radiance) sum += static_cast<double>(p.y);
  return sum / static_cast<double>(film.count());
}

TEST(Reflections, EveryMethodShowsTheLobesAlbedoInAnEvenlyBrightRoom) {
  for (const double roughness : {0.3, 0.5, 0.7}) {
    const auto scene = furnace(roughness);
    const double rays = seen(*scene, Reflections::rays);
    EXPECT_GT(rays, 30.0);
    // The lobe's two round parts look below the plate where wide ones do, and see the room's dark
    // foot there (3.7 % at roughness 0.7).
    EXPECT_NEAR(seen(*scene, Reflections::maps), rays, 0.05 * rays) << roughness;
    // Harmonics of half a bright sphere: `edge` of core/glossy/README.md and its 512 directions.
    EXPECT_NEAR(seen(*scene, Reflections::harmonics), rays, 0.05 * rays) << roughness;
    EXPECT_EQ(seen(*scene, Reflections::none), 0.0) << roughness;
  }
}

TEST(Reflections, AutomaticTracesFinalPicturesAndHastensQuickOnes) {
  EXPECT_EQ(settled(Reflections::automatic, false), Reflections::rays);
  EXPECT_EQ(settled(Reflections::automatic, true), Reflections::harmonics);
  for (const Reflections chosen : {Reflections::none, Reflections::maps, Reflections::rays}) {
    EXPECT_EQ(settled(chosen, true), chosen);
    EXPECT_EQ(settled(chosen, false), chosen);
  }
  const auto scene = furnace(0.7);
  EXPECT_EQ(seen(*scene, Reflections::automatic), seen(*scene, Reflections::rays));
  EXPECT_EQ(seen(*scene, Reflections::automatic, true), seen(*scene, Reflections::harmonics));
}

TEST(Reflections, MirrorsAreTracedByEveryMethodButNone) {
  const auto scene = furnace(0.0);
  const double rays = seen(*scene, Reflections::rays);
  EXPECT_GT(rays, 50.0);
  EXPECT_EQ(seen(*scene, Reflections::maps), rays);
  EXPECT_EQ(seen(*scene, Reflections::harmonics), rays);
  EXPECT_EQ(seen(*scene, Reflections::none), 0.0);
}

}  // namespace
}  // namespace soffit::render
