// SPDX-License-Identifier: MIT
#include "core/render/view_renderer.h"

#include "core/base/parallel.h"
#include "core/render/camera_frame.h"
#include "core/render/picture.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265F;
constexpr float kRoundoff = 1e-5F;

/// Looks down at the origin from 5 m; 60 degrees.
const scene::Camera kFromAbove{"Above", {0, 0, 5}, {0, 0, 0}, 60.0};

RenderOptions small(int width = 32, int height = 24, int samples = 4) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.samples = samples;
  return options;
}

light::Luminaire lamp(const light::Shape& shape, const dvec3& position, double flux) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  l.position = position;
  l.flux = flux;
  return l;
}

TEST(RenderView, ShowsAlbedoTimesIlluminanceOverPi) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(0.2, 0.5, 0.8)}));
  const auto scene = builder.build();
  const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(500, 400, 300)), small()).value();
  const vec3 expected = vec3(0.2F, 0.5F, 0.8F) * vec3(500, 400, 300) / kPiF;
  for (std::size_t i = 0; i < film.count(); ++i) {
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(film.radiance[i][c], expected[c], kRoundoff * expected[c]);
    ASSERT_NEAR(film.lux[i], 0.212639F * 500 + 0.715169F * 400 + 0.072192F * 300, 0.01F);
    ASSERT_EQ(film.surface[i], 1.0F);
    ASSERT_NE(film.triangle[i], geometry::kNoTriangle);
  }
}

TEST(RenderView, APointLightFollowsCosineAndSquareOfTheDistance) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(0.5)}));
  auto source = lamp(light::PointShape{}, {1, 0, 2}, 4 * kPi * 100.0);
  source.distribution.kind = light::DistributionKind::isotropic;  // 100 cd
  const auto scene = builder.build({source});
  const SampledLight light(*scene, 1, vec3(0));
  const RenderOptions options = small(64, 48, 1);
  const auto film = renderView(*scene, kFromAbove, light, options).value();
  const auto frame = CameraFrame::create(kFromAbove, 64, 48).value();
  for (const int x : {3, 20, 31, 50}) {
    for (const int y : {2, 24, 40}) {
      const geometry::Ray ray = frame.ray(x + 0.5, y + 0.5);
      const dvec3 eye(ray.origin);
      const dvec3 hit = eye - dvec3(ray.direction) * eye.z / dvec3(ray.direction).z;
      // Points are lit 1 mm nearer to the eye (surface_sample.h).
      const dvec3 level = -dvec3(ray.direction.x, ray.direction.y, 0.0F);
      const dvec3 p = hit + 1e-3 / std::max(glm::length(level), 0.02) * level;
      const dvec3 d = dvec3(1, 0, 2) - p;
      const double r = glm::length(d);
      const double expected = 0.5 / kPi * 100.0 * (d.z / r) / (r * r);
      // Single precision, and the origin that is lifted off the floor.
      EXPECT_NEAR(film.radiance[film.at(x, y)].y, expected, 1e-4 * expected);
    }
  }
}

TEST(RenderView, LuminairesShowTheirLuminanceExactly) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 3}, {0, 100, 0}, {100, 0, 0}, builder.addMaterial({}));
  // Flush with the ceiling that it hangs on.
  auto panel = lamp(light::Rectangle{1.0, 0.5}, {0, 0, 3}, 3000.0);
  panel.colour.rgb = {1.0, 0.8, 0.5};
  const auto scene = builder.build({panel});
  const scene::Camera up{"Up", {0, 0, 0}, {0, 0, 3}, 60.0};
  const auto film = renderView(*scene, up, EvenLight(vec3(100)), small(64, 48)).value();
  const double y = 0.2126390058715104 + 0.8 * 0.7151686787677560 + 0.5 * 0.0721923153607336;
  const double luminance = 3000.0 / (kPi * 0.5);
  const vec3 expected(dvec3(1.0, 0.8, 0.5) / y * luminance);
  const std::size_t middle = film.at(32, 24);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(film.radiance[middle][c], expected[c], kRoundoff * expected[c]);
  EXPECT_EQ(film.lamp[middle], 1.0F);
  EXPECT_EQ(film.surface[middle], 0.0F);
  EXPECT_EQ(film.lux[middle], 0.0F);
}

TEST(RenderView, BacksAreInvisibleUnlessTheyAreBodies) {
  for (const bool body : {false, true}) {
    SceneBuilder builder;
    builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                    builder.addMaterial({.diffuse = dvec3(1.0)}));
    auto panel =
        lamp(light::Rectangle{1.0, 1.0}, {0, 0, 2}, 3000.0);  // emits down, seen from above
    panel.casts_shadow = body;
    const auto scene = builder.build({panel});
    const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(kPiF)), small()).value();
    EXPECT_NEAR(film.radiance[film.at(16, 12)].x, body ? 0.0F : 1.0F, kRoundoff);
    EXPECT_NEAR(film.radiance[film.at(1, 1)].x, 1.0F, kRoundoff);
  }
}

TEST(RenderView, EdgesAreCoveredByTheFilter) {
  // A dark and a bright half plane meet on the line x = 0, which is the edge between two pixels.
  SceneBuilder builder;
  const auto dark = builder.addMaterial({.diffuse = dvec3(0.0)});
  const auto bright = builder.addMaterial({.diffuse = dvec3(1.0)});
  builder.addQuad({-50, -50, 0}, {50, 0, 0}, {0, 100, 0}, dark);
  builder.addQuad({0, -50, 0}, {50, 0, 0}, {0, 100, 0}, bright);
  const auto scene = builder.build();
  const auto film =
      renderView(*scene, kFromAbove, EvenLight(vec3(kPiF)), small(32, 32, 64)).value();
  // The tent reaches half a pixel over the edge: its integral there is 1/8.
  for (int y = 0; y < 32; ++y) {
    EXPECT_NEAR(film.radiance[film.at(14, y)].x, 0.0F, kRoundoff);
    EXPECT_NEAR(film.radiance[film.at(15, y)].x, 0.125F, 1.0F / 64);  // one of 64 samples
    EXPECT_NEAR(film.radiance[film.at(16, y)].x, 0.875F, 1.0F / 64);
    EXPECT_NEAR(film.radiance[film.at(17, y)].x, 1.0F, kRoundoff);
  }
}

TEST(RenderView, FourSamplesGiveSlantedEdgesFiveLevels) {
  SceneBuilder builder;
  const auto bright = builder.addMaterial({.diffuse = dvec3(1.0)});
  builder.addQuad({0, 0, 0}, {50, 5, 0}, {-5, 50, 0}, bright);
  const auto scene = builder.build();
  const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(kPiF)), small(64, 64)).value();
  std::vector<int> levels(5, 0);
  for (const vec3& p : film.radiance) ++levels[static_cast<std::size_t>(std::lround(4.0F * p.x))];
  for (const int count : levels) EXPECT_GT(count, 5);
}

TEST(RenderView, ShadowEdgesTakeAllSamples) {
  // A point light, a half plane in its way: a hard shadow on one and the same floor triangle.
  SceneBuilder builder;
  const auto white = builder.addMaterial({.diffuse = dvec3(1.0)});
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, white);
  builder.addQuad({6, -50, 1}, {50, 0, 0}, {0, 100, 0}, white);
  auto source = lamp(light::PointShape{}, {12, 0, 2}, 4000.0);  // its shadow ends at x = 0
  source.distribution.kind = light::DistributionKind::isotropic;
  const auto scene = builder.build({source});
  const SampledLight light(*scene, 1, vec3(10));
  const scene::Camera camera{"A", {-1, 0, 5}, {-1, 0.01, 0}, 40.0};
  const auto film = renderView(*scene, camera, light, small(400, 30)).value();
  // Somewhere in each row a pixel lies between lit and dark.
  int between = 0;
  for (int y = 0; y < 30; ++y) {
    float least = 1e9F;
    float most = 0.0F;
    for (int x = 200; x < 300; ++x) {
      least = std::min(least, film.lux[film.at(x, y)]);
      most = std::max(most, film.lux[film.at(x, y)]);
    }
    ASSERT_GT(most, 1.2F * least);
    for (int x = 200; x < 300; ++x) {
      const float place = (film.lux[film.at(x, y)] - least) / (most - least);
      if (place > 0.2F && place < 0.8F) ++between;
    }
  }
  EXPECT_GT(between, 10);
}

TEST(RenderView, BrightEdgesCanBeWeighted) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(1.0)}));
  auto panel = lamp(light::Rectangle{2.0, 2.0}, {1, 0, 1}, 40000.0);
  panel.rotation_deg = {180, 0, 0};  // towards the camera
  const auto scene = builder.build({panel});
  RenderOptions options = small(33, 33);
  const auto plain = renderView(*scene, kFromAbove, EvenLight(vec3(10 * kPiF)), options).value();
  options.edge_white = 100.0F;
  const auto weighted = renderView(*scene, kFromAbove, EvenLight(vec3(10 * kPiF)), options).value();
  const float bright = static_cast<float>(40000.0 / (kPi * 4.0));
  int mixed = 0;
  for (std::size_t i = 0; i < plain.count(); ++i) {
    if (plain.lamp[i] > 0.0F && plain.lamp[i] < 1.0F) {
      ++mixed;
      EXPECT_NEAR(plain.radiance[i].x, bright * plain.lamp[i] + 10 * plain.surface[i],
                  1e-3F * bright);
      EXPECT_LT(weighted.radiance[i].x, 0.5F * plain.radiance[i].x);
    } else {
      // A pixel of one kind keeps its value: the curve is undone, to rounding.
      EXPECT_NEAR(weighted.radiance[i].x, plain.radiance[i].x, 1e-4F * plain.radiance[i].x);
    }
  }
  EXPECT_GT(mixed, 3);
}

TEST(RenderView, GlassDimsWhatIsBehindItAndNothingShowsTheBackground) {
  SceneBuilder builder;
  // The camera looks down: a sheet halfway, on the right a floor below it.
  builder.addQuad({0, -50, 0}, {50, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(0.9), .glass = scene::Glass{1.0, 0.5}}));
  const auto scene = builder.build();
  RenderOptions options = small();
  options.background = vec3(8, 6, 4);
  const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(100)), options).value();
  // Index 1 absorbs alone: 0.5^(1 / cos), little less than a half near the middle.
  const vec3 seen = film.radiance[film.at(18, 12)];
  EXPECT_LT(seen.x, 4.0F);
  EXPECT_GT(seen.x, 3.0F);
  EXPECT_NEAR(seen.y / seen.x, 0.75F, 1e-4F);
  EXPECT_EQ(film.radiance[film.at(2, 12)], vec3(8, 6, 4));
  EXPECT_EQ(film.triangle[film.at(2, 12)], geometry::kNoTriangle);
  EXPECT_EQ(film.triangle[film.at(30, 12)], geometry::kNoTriangle) << "the eye looks through";
}

TEST(RenderView, TheSkyIsSeenWhereNothingElseIs) {
  SceneBuilder builder;
  builder.setEnvironment(
      {"", scene::Sky{.cie = 5, .horizontal_illuminance = 314.159265, .ground_reflectance = 0.5}});
  const auto scene = builder.build();
  RenderOptions options = small();
  options.background = vec3(7, 8, 9);
  // Straight down: the ground, 0.5 of the even sky's 100 cd/m^2.
  const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(100)), options).value();
  EXPECT_NEAR(film.radiance[film.at(16, 12)].y, 50.0F, 1e-3F);
}

TEST(RenderView, AnEmptySceneIsLegal) {
  SceneBuilder builder;
  const auto scene = builder.build({lamp(light::Sphere{1.0}, {0, 0, 0}, 1000.0)});
  const auto film = renderView(*scene, kFromAbove, EvenLight(vec3(100)), small()).value();
  EXPECT_GT(film.radiance[film.at(16, 12)].y, 10.0F);
  EXPECT_EQ(film.radiance[0], vec3(0));
}

/// A room with a bit of everything.
std::unique_ptr<ViewScene> furnishedRoom() {
  SceneBuilder builder;
  const auto white = builder.addMaterial({.diffuse = dvec3(0.7)});
  const auto gloss =
      builder.addMaterial({.diffuse = dvec3(0.3), .specular = 0.05, .roughness = 0.3});
  const auto mirror =
      builder.addMaterial({.diffuse = dvec3(0.0), .specular = 0.9, .roughness = 0.0});
  builder.addBox({-2, -2, 0}, {2, 2, 2.5F}, white, true);
  builder.addBox({-1, 0, 0}, {-0.2F, 0.7F, 0.8F}, gloss);
  builder.addSphere({0.6F, 0.5F, 0.5F}, 0.5F, 16, mirror);
  return builder.build({lamp(light::Rectangle{0.6, 0.6}, {0, 0, 2.5}, 3000.0),
                        lamp(light::Sphere{0.1}, {1, -1, 1.5}, 500.0)});
}

const scene::Camera kInside{"Inside", {0, -1.9, 1.5}, {0, 1, 0.7}, 70.0};

TEST(RenderView, DoesNotDependOnTheThreadCount) {
  const auto scene = furnishedRoom();
  const SampledLight light(*scene, 4, vec3(50));
  setThreadCount(1);
  const auto one = renderView(*scene, kInside, light, small(70, 50)).value();
  setThreadCount(4);
  const auto four = renderView(*scene, kInside, light, small(70, 50)).value();
  setThreadCount(0);
  EXPECT_EQ(one.radiance, four.radiance);
  EXPECT_EQ(one.lux, four.lux);
}

TEST(RenderView, ValuesAreFiniteAndNotNegative) {
  const auto scene = furnishedRoom();
  const auto film =
      renderView(*scene, kInside, SampledLight(*scene, 4, vec3(50)), small(80, 60)).value();
  for (const vec3& p : film.radiance) {
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(p[c]) && p[c] >= 0.0F);
  }
}

/// Counts what is asked of it.
class CountingLight : public EvenLight {
 public:
  using EvenLight::EvenLight;
  void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                std::span<vec3> indirect) const override {
    asked += points.size();
    EvenLight::evaluate(points, direct, indirect);
  }
  mutable std::atomic<std::size_t> asked{0};
};

TEST(RenderView, AsksForTheLightAboutOncePerPixel) {
  const auto scene = furnishedRoom();
  RenderOptions options = small(160, 120);
  options.max_reflections = 0;
  const CountingLight light(vec3(100));
  ASSERT_TRUE(renderView(*scene, kInside, light, options).ok());
  EXPECT_LT(static_cast<double>(light.asked), 1.15 * 160 * 120);  // of 4 samples a pixel
}

TEST(RenderView, BrokenLightCountsAsDarkness) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, builder.addMaterial({}));
  const auto scene = builder.build();
  const auto film =
      renderView(*scene, kFromAbove, EvenLight(vec3(std::nanf(""), -5, 100)), small()).value();
  EXPECT_EQ(film.radiance[0].x, 0.0F);
  EXPECT_EQ(film.radiance[0].y, 0.0F);
  EXPECT_GT(film.radiance[0].z, 0.0F);
}

TEST(RenderView, CanBeCancelledAndReportsProgress) {
  struct Watcher : ProgressObserver {
    void onProgress(std::string_view, double done) override {
      if (done >= 1.0) ++finished;
    }
    std::atomic<int> finished{0};
  } watcher;
  const auto scene = furnishedRoom();
  const EvenLight light(vec3(100));
  ASSERT_TRUE(renderView(*scene, kInside, light, small(), {&watcher, {}}).ok());
  EXPECT_EQ(watcher.finished, 3);  // pixels, edges, and reflections: something curved reflects
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(
      renderView(*scene, kInside, light, small(), {nullptr, stop.get_token()}).error().message(),
      "rendering was cancelled");
}

TEST(RenderView, SaysWhatIsWrong) {
  const auto scene = furnishedRoom();
  EXPECT_EQ(renderView(*scene, kInside, EvenLight(vec3(1)), small(8, 8, 0)).error().message(),
            "samples: expected 1 to 1024 per pixel, found 0. 4 is a good number, 16 for print.");
  EXPECT_FALSE(renderView(*scene, kInside, EvenLight(vec3(1)), small(0, 8)).ok());
}

}  // namespace
}  // namespace soffit::render
