// SPDX-License-Identifier: MIT
#include "core/render/surface_sample.h"

#include "core/render/microfacet.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

namespace soffit::render {
namespace {

SurfaceSample shoot(const ViewScene& scene, const vec3& origin, const vec3& direction,
                    const SurfaceOptions& options = {}) {
  const geometry::Ray ray{.origin = origin, .direction = glm::normalize(direction)};
  const geometry::Hit hit = scene.caster().closest(ray);
  EXPECT_TRUE(hit.valid());
  return sampleSurface(scene, ray, hit, options);
}

TEST(SurfaceSample, FacesTheEyeOnBothSides) {
  SceneBuilder builder;
  builder.addQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.addMaterial({}));
  const auto scene = builder.build();
  const SurfaceSample above = shoot(*scene, {0.3F, 0.4F, 2}, {0, 0, -1}, {.spread = 0.01F});
  EXPECT_EQ(above.point.normal, vec3(0, 0, 1));
  EXPECT_EQ(above.point.shading_normal, vec3(0, 0, 1));
  EXPECT_NEAR(glm::length(above.point.position - vec3(0.3F, 0.4F, 0)), 0.0F, 1e-6F);
  EXPECT_FLOAT_EQ(above.footprint, 0.02F);
  EXPECT_EQ(shoot(*scene, {0.3F, 0.4F, -2}, {0, 0, 1}).point.normal, vec3(0, 0, -1));
}

TEST(SurfaceSample, ThePointIsDrawnTowardTheEyeAlongItsSurface) {
  SceneBuilder builder;
  // The quad's diagonal, an edge of its triangles, passes the place at a metre.
  builder.addQuad({-5, -6, 0}, {10, 0, 0}, {0, 10, 0}, builder.addMaterial({}));
  const auto scene = builder.build();
  // Round-off: coordinates of a few metres in single precision.
  constexpr float kRoundoff = 1e-6F;
  const vec3 eye(3, 0, 4);
  const SurfaceSample wide = shoot(*scene, eye, -eye, {.footprint = 0.1F});
  EXPECT_NEAR(wide.point.position.x, 1e-3F, kRoundoff);
  EXPECT_NEAR(wide.point.position.z, 0.0F, kRoundoff) << "it stays on the surface";
  const SurfaceSample narrow = shoot(*scene, eye, -eye, {.footprint = 1e-4F});
  EXPECT_NEAR(narrow.point.position.x, 5e-5F, kRoundoff) << "never by more than half a pixel";
  EXPECT_NEAR(shoot(*scene, {0, 0, 4}, {0, 0, -1}, {.footprint = 0.1F}).point.position.x, 0.0F,
              kRoundoff);
}

TEST(SurfaceSample, ThePointIsNotDrawnOverARidge) {
  // The flank of a flute, 4 mm wide, ends at x = 0; what is seen beyond lies deeper.
  SceneBuilder builder;
  builder.addQuad({-4e-3F, -1, 0}, {4e-3F, 0, 0}, {0, 2, 0}, builder.addMaterial({}));
  const auto scene = builder.build();
  const vec3 toward(0.6F, 0, 0.8F);
  for (int i = 0; i < 100; ++i) {
    const dvec2 u = r2Sequence(static_cast<std::uint32_t>(i));
    const vec3 met(-4e-3F * static_cast<float>(u.x), static_cast<float>(u.y) - 0.5F, 0.0F);
    const geometry::Ray ray{.origin = met + toward, .direction = -toward};
    const geometry::Hit hit = scene->caster().closest(ray);
    if (!hit.valid()) continue;
    const float x = sampleSurface(*scene, ray, hit, {.footprint = 0.1F}).point.position.x;
    // Round-off of coordinates of a metre, and of the place that the ray meets.
    constexpr float kRoundoff = 1e-6F;
    EXPECT_GE(x, met.x - kRoundoff) << "toward the eye";
    EXPECT_LE(x, 0.5F * met.x + kRoundoff) << "half the way to the ridge at most";
  }
}

TEST(SurfaceSample, AlbedoFollowsTheTexture) {
  SceneBuilder builder;
  auto image =
      std::make_shared<scene::Image>(scene::Image{2, 2, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}});
  builder.addQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                  builder.addMaterial({.diffuse = dvec3(0.5), .diffuse_image = image}));
  const auto scene = builder.build();
  // u along x, v along y; the picture's first row is at the top, v = 1.
  EXPECT_EQ(shoot(*scene, {0.25F, 0.75F, 1}, {0, 0, -1}).albedo, vec3(0.5F, 0, 0));
  EXPECT_EQ(shoot(*scene, {0.25F, 0.25F, 1}, {0, 0, -1}).albedo, vec3(0, 0, 0.5F));
}

TEST(SurfaceSample, RoughnessFollowsItsMap) {
  const auto tiled = [](double roughness) {
    SceneBuilder builder;
    auto image =
        std::make_shared<scene::Image>(scene::Image{2, 1, 3, {0.1F, 0.5F, 0.9F, 0.1F, 0.0F, 0.9F}});
    builder.addQuad(
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
        builder.addMaterial({.specular = 0.04, .roughness = roughness, .roughness_image = image}));
    return builder.build();
  };
  const auto scene = tiled(0.8);
  EXPECT_NEAR(shoot(*scene, {0.25F, 0.5F, 1}, {0, 0, -1}).alpha, 0.16F, 1e-6F);
  EXPECT_EQ(shoot(*scene, {0.75F, 0.5F, 1}, {0, 0, -1}).alpha, kMirrorAlpha)
      << "a map makes no mirror";
  EXPECT_NEAR(scene->material(0).least_alpha, kMirrorAlpha, 1e-9F);
  EXPECT_NEAR(scene->material(0).mean_alpha, 0.04F, 1e-6F) << "of the mean roughness 0.2";
  EXPECT_EQ(shoot(*tiled(0.0), {0.25F, 0.5F, 1}, {0, 0, -1}).alpha, 0.0F) << "what is one stays it";
}

TEST(SurfaceSample, NormalMapsBendTheShadingNormalAlongUAndV) {
  const auto tilted = [](float r, float g) {
    SceneBuilder builder;
    auto image = std::make_shared<scene::Image>(scene::Image{1, 1, 3, {r, g, 0.9F}});
    builder.addQuad({0, 0, 0}, {0, 2, 0}, {-1, 0, 0}, builder.addMaterial({.normal_image = image}));
    return builder.build();
  };
  const auto flat = tilted(0.5F, 0.5F);
  const auto along_u = tilted(0.8F, 0.5F);
  const auto along_v = tilted(0.5F, 0.8F);
  const vec3 eye(-0.3F, 0.4F, 3);
  EXPECT_NEAR(shoot(*flat, eye, {0, 0, -1}).point.shading_normal.z, 1.0F, 1e-6F);
  // u runs along +y, v along -x: (0.6, 0, 0.8) of the map is (0, 0.6, 0.8) of the room.
  const vec3 u = shoot(*along_u, eye, {0, 0, -1}).point.shading_normal;
  EXPECT_NEAR(glm::length(u - vec3(0, 0.6F, 0.8F)), 0.0F, 1e-6F);
  const vec3 v = shoot(*along_v, eye, {0, 0, -1}).point.shading_normal;
  EXPECT_NEAR(glm::length(v - vec3(-0.6F, 0, 0.8F)), 0.0F, 1e-6F);
  // Seen from behind, the bump is a dent: the normal is the mirrored one.
  const vec3 back = shoot(*along_u, {-0.3F, 0.4F, -3}, {0, 0, 1}).point.shading_normal;
  EXPECT_NEAR(glm::length(back - vec3(0, -0.6F, -0.8F)), 0.0F, 1e-6F);
  // Where illuminance is asked for, the plane counts.
  EXPECT_EQ(shoot(*along_u, eye, {0, 0, -1}, {.plain_normals = true}).point.shading_normal,
            vec3(0, 0, 1));
}

TEST(SurfaceSample, SmoothSurfacesAreLiftedToTheCurve) {
  SceneBuilder builder;
  builder.addSphere({0, 0, 0}, 1.0F, 12, builder.addMaterial({}));
  const auto scene = builder.build();
  for (int i = 0; i < 50; ++i) {
    const dvec2 u = r2Sequence(static_cast<std::uint32_t>(i));
    const vec3 d = uniformSphere(static_cast<float>(u.x), static_cast<float>(u.y));
    const SurfaceSample s = shoot(*scene, 3.0F * d, -d);
    const float radius = glm::length(s.point.position);
    // The facets of 15 degrees lie up to 1.7 % inside the sphere; the lift ends between the facet
    // and the tangent planes of the corners, which are as far outside.
    EXPECT_GT(radius, 0.99F);
    EXPECT_LT(radius, 1.017F);
    EXPECT_GT(glm::dot(s.point.shading_normal, d), 0.995F);
  }
}

TEST(SurfaceSample, ShadingNormalsNeverFaceAway) {
  SceneBuilder builder;
  builder.addSphere({0, 0, 0}, 1.0F, 4, builder.addMaterial({}));
  const auto scene = builder.build();
  for (float y = -0.98F; y < 1.0F; y += 0.02F) {
    const geometry::Ray ray{.origin = {3, y, 0.1F}, .direction = {-1, 0, 0}};
    const geometry::Hit hit = scene->caster().closest(ray);
    if (!hit.valid()) continue;
    const SurfaceSample s = sampleSurface(*scene, ray, hit, {});
    EXPECT_GT(glm::dot(s.point.shading_normal, s.to_eye), 0.0F);
    EXPECT_GT(glm::dot(s.point.normal, s.to_eye), 0.0F);
  }
}

}  // namespace
}  // namespace soffit::render
