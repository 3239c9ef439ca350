// SPDX-License-Identifier: MIT
#include "core/render/tile_renderer.h"

#include "core/color/luminance.h"
#include "core/render/camera_frame.h"
#include "core/render/pixel_pattern.h"
#include "core/render/surface_sample.h"
#include "core/render/view_renderer.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::render {
namespace {

TEST(TileRenderer, ThePlaceThatLightsAPixelIsNotAtItsRim) {
  // Flutes about as wide as a pixel and bent by so little that its samples share their light: a
  // shadow's edge, which no neighbour on the same facet tells, falls into many pixels.
  SceneBuilder builder;
  const auto white = builder.addMaterial({.diffuse = dvec3(1.0)});
  constexpr float kWidth = 0.2F;
  for (int i = -40; i < 40; ++i) {
    const float rise = i % 2 == 0 ? 2e-3F : -2e-3F;
    builder.addQuad({kWidth * static_cast<float>(i), -8, i % 2 == 0 ? 0.0F : 2e-3F},
                    {kWidth, 0, rise}, {0, 16, 0}, white);
  }
  builder.addQuad({4, -50, 1}, {50, 0, 0}, {4, 100, 0}, white);  // its shadow ends about x = 0
  light::Luminaire source;
  source.name = "L";
  source.shape = light::PointShape{};
  source.position = {12, 0, 2};
  source.flux = 4000.0;
  source.distribution.kind = light::DistributionKind::isotropic;
  const auto scene = builder.build({source});
  const SampledLight light(*scene, 1, vec3(0));
  const scene::Camera camera{"Above", {0, 0, 5}, {0, 0, 0}, 60.0};
  const auto frame = CameraFrame::create(camera, 32, 24).value();
  for (const int samples : {4, 16}) {
    RenderOptions options;
    options.width = 32;
    options.height = 24;
    options.samples = samples;
    const auto film = renderView(*scene, camera, light, options).value();
    const auto pattern = pixelPattern(256);
    int dark = 0;
    int bright = 0;
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 32; ++x) {
        std::vector<SurfacePoint> points;
        for (const vec2& offset : pattern) {
          const geometry::Ray ray = frame.ray(x + 0.5 + static_cast<double>(offset.x),
                                              y + 0.5 + static_cast<double>(offset.y));
          points.push_back(sampleSurface(*scene, ray, scene->caster().closest(ray), {}).point);
        }
        std::vector<vec3> direct(points.size(), vec3(0.0F)), indirect(direct);
        light.evaluate(points, direct, indirect);
        float lux = 0.0F;
        float lit = 0.0F;
        for (const vec3& e : direct) {
          lux = std::max(lux, color::luminance(e));
          lit += e.x > 0.0F ? 1.0F / static_cast<float>(direct.size()) : 0.0F;
        }
        // A straight edge that leaves a pixel less than a quarter of its light lies beyond the
        // sample in the middle, wherever it runs.
        if (lit > 0.0F && lit < 0.25F) {
          ++dark;
          EXPECT_LT(film.lux[film.at(x, y)], 0.5F * lux) << x << ' ' << y << " of " << samples;
        } else if (lit > 0.75F && lit < 1.0F) {
          ++bright;
          EXPECT_GT(film.lux[film.at(x, y)], 0.5F * lux) << x << ' ' << y << " of " << samples;
        }
      }
    }
    EXPECT_GT(dark, 5);
    EXPECT_GT(bright, 5);
  }
}

}  // namespace
}  // namespace soffit::render
