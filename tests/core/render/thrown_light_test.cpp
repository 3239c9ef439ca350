// SPDX-License-Identifier: MIT
#include "core/render/thrown_light.h"

#include "core/base/parallel.h"
#include "core/reference/estimate.h"
#include "core/relight/reflectance.h"
#include "core/render/engine_light.h"
#include "tests/core/render/lit_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

using testing::kHeight;
using testing::LitRoom;
using testing::material;
using testing::spot;

TEST(ThrownLight, AMirrorFloorShowsASecondLampBelow) {
  const LitRoom room(material(0.0, 1.0, 0.0), material(0.0, 0.0, 0.5), {spot()});
  constexpr std::size_t kSamples = 1U << 20U;
  const auto lux = thrownLight(*room.view, *room.lighting, {.samples = kSamples, .most_passes = 1});
  ASSERT_TRUE(lux.ok());
  // A small Lambertian panel facing down, mirrored: I = flux / pi cos, E = I cos' / d^2.
  const dvec3 image(1.2, 1.5, -2.0);
  double squares = 0.0;
  double expected_squares = 0.0;
  int counted = 0;
  for (std::size_t s = 0; s < room.texels().slotCount(); ++s) {
    const dvec3 p(room.texels().receivers.position(static_cast<std::uint32_t>(s)));
    if (room.texels().area[s] <= 0.0F || p.z < 2.99) continue;
    const double d2 = glm::dot(p - image, p - image);
    const double cosine = (p.z - image.z) / std::sqrt(d2);
    const double wanted = 1000.0 / kPi * cosine * cosine / d2;
    const double found = static_cast<double>((*lux)[1][s]);
    squares += (found - wanted) * (found - wanted);
    // Places are drawn by the light on the floor: particles carry nearly equal flux, at most four
    // times the mean, and a texel's variance is its lumens times one particle's.
    const double particle = 4.0 * 1000.0 / static_cast<double>(kSamples);
    expected_squares += wanted * particle / static_cast<double>(room.texels().area[s]);
    ++counted;
  }
  ASSERT_GT(counted, 400);
  EXPECT_LT(squares, expected_squares);
}

TEST(ThrownLight, WhatArrivesLeavesByTheLobe) {
  // Every lumen on a white metal floor leaves it but for the lobe's single-scattering loss, and
  // lands: walls, ceiling and, after another reflection, nowhere else in a convex room.
  const LitRoom room(material(0.0, 1.0, 0.5), material(0.4, 0.0, 0.5), {spot()});
  const auto lux = thrownLight(*room.view, *room.lighting, {.most_passes = 1});
  ASSERT_TRUE(lux.ok());
  const relight::Planes total = room.lighting->total();
  double arriving = 0.0;
  for (std::size_t s = 0; s < total[1].size(); ++s) {
    const vec3 p = room.texels().receivers.position(static_cast<std::uint32_t>(s));
    if (p.z < 1e-3F) {
      arriving += static_cast<double>(total[1][s]) * static_cast<double>(room.texels().area[s]);
    }
  }
  // Off by the statistics (2e-3), the quadrature of the albedo, which depends on direction where
  // light from a lamp is not even (1e-2), and the engine's own light on the floor (1e-2).
  EXPECT_NEAR(room.flux((*lux)[1]) / arriving, relight::lobeAlbedo(1.0, 0.5), 0.02);
}

TEST(ThrownLight, BringsTheCeilingNearThePathTracer) {
  const scene::Material floor = material(0.1, 0.6, 0.25);
  light::Luminaire lamp = spot();
  lamp.rotation_deg = {0.0, -55.0, 0.0};  // at the floor's far half: the lobe throws it on
  const LitRoom room(floor, material(0.1, 0.0, 0.5), {lamp});
  const auto plain = std::make_shared<const EngineLight>(room.lighting);
  const auto thrown = EngineLight::withThrownLight(room.lighting, *room.view, {.noise = 0.003});
  ASSERT_TRUE(thrown.ok());
  std::vector<scene::Sensor> sensors;
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 16; ++i) {
    const vec3 p(0.4F + 1.0F * static_cast<float>(i % 4), 0.5F + 0.95F * static_cast<float>(i / 4),
                 kHeight);
    sensors.push_back({dvec3(p), {0, 0, -1}});
    const std::uint32_t triangle = p.x > p.y ? 3 : 2;
    points.push_back({p, {0, 0, -1}, {0, 0, -1}, triangle, {0.0F, 0.0F}});
  }
  const auto reference = reference::ReferenceScene::make(room.scene, room.scene.luminaires).value();
  reference::EstimateOptions options;
  options.relative_error = 0.01;
  const auto wanted = reference::estimate(reference, sensors, options).sensors;
  const auto rmsOf = [&](const EngineLight& light) {
    std::vector<vec3> direct(points.size()), indirect(points.size());
    light.evaluate(points, direct, indirect);
    double squares = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double e = static_cast<double>(direct[i].y + indirect[i].y) - wanted[i].total;
      squares += e * e;
      mean += wanted[i].total;
    }
    const auto n = static_cast<double>(points.size());
    return std::sqrt(squares / n) / (mean / n);
  };
  // 5.4 % with the lobe taken for diffuse reflection, 1.6 % with what it throws: the reference's
  // own 1 %, the engine's in so coarse a bake and a texel's noise.
  EXPECT_GT(rmsOf(*plain), 0.045);
  EXPECT_LT(rmsOf(**thrown), 0.022);
}

TEST(ThrownLight, CostsNothingWhereNothingReflects) {
  const LitRoom room(material(0.3, 0.0, 0.5), material(0.5, 0.0, 0.5), {spot()});
  const auto lux = thrownLight(*room.view, *room.lighting);
  ASSERT_TRUE(lux.ok());
  for (const auto& plane : *lux) EXPECT_TRUE(plane.empty());
  const auto same = EngineLight::withThrownLight(room.lighting, *room.view);
  ASSERT_TRUE(same.ok());
  const std::vector<SurfacePoint> point{{{1, 1, 0}, {0, 0, 1}, {0, 0, 1}, 0, {0.5F, 0.25F}}};
  std::vector<vec3> a(1), b(1), c(1), d(1);
  (*same)->evaluate(point, a, b);
  EngineLight(room.lighting).evaluate(point, c, d);
  EXPECT_EQ(a[0], c[0]);
  EXPECT_EQ(b[0], d[0]);
}

TEST(ThrownLight, IsTheSameOnAnyNumberOfThreadsAndStopsWhenAsked) {
  const LitRoom room(material(0.2, 0.3, 0.4), material(0.5, 0.0, 0.5), {spot()});
  const ThrownLightOptions options{.samples = 1U << 14U, .noise = 0.0, .most_passes = 2};
  setThreadCount(1);
  const auto one = thrownLight(*room.view, *room.lighting, options);
  setThreadCount(0);
  const auto all = thrownLight(*room.view, *room.lighting, options);
  ASSERT_TRUE(one.ok() && all.ok());
  EXPECT_EQ((*one)[0], (*all)[0]);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(thrownLight(*room.view, *room.lighting, options, {nullptr, stop.get_token()}).ok());
  EXPECT_FALSE(
      EngineLight::withThrownLight(room.lighting, *room.view, options, {nullptr, stop.get_token()})
          .ok());
}

}  // namespace
}  // namespace soffit::render
