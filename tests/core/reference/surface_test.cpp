// SPDX-License-Identifier: MIT
#include "core/reference/surface.h"

#include "rooms.h"

#include <gtest/gtest.h>

namespace soffit::reference {
namespace {

std::shared_ptr<const scene::Image> checker() {
  auto image = std::make_shared<scene::Image>();
  image->width = 2;
  image->height = 2;
  image->channels = 3;
  // Upper row black and red, lower row green and white.
  image->pixels = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1};
  return image;
}

void expectNear(const dvec3& found, const dvec3& expected) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-6);  // float barycentrics
}

TEST(LookUp, IsBilinearUpwardsAndRepeats) {
  const auto image = checker();
  expectNear(lookUp(*image, {0.25, 0.25}), {0, 1, 0});  // centre of the lower left pixel
  expectNear(lookUp(*image, {0.75, 0.25}), {1, 1, 1});
  expectNear(lookUp(*image, {0.25, 0.75}), {0, 0, 0});
  expectNear(lookUp(*image, {0.75, 0.75}), {1, 0, 0});
  expectNear(lookUp(*image, {0.5, 0.25}), {0.5, 1, 0.5});
  expectNear(lookUp(*image, {-0.75, 3.25}), {0, 1, 0});
  expectNear(lookUp(*image, {0.0, 0.0}), {0.5, 0.5, 0.25});  // all four meet at the corner
}

TEST(SurfaceAt, TakesTheMapOntoTheDiffuseReflectance) {
  scene::Material m = test::matte(0.5);
  m.diffuse_image = checker();
  const scene::Scene s = test::Builder().quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m).scene();
  const geometry::RayCaster caster(s.mesh->positions, s.mesh->triangles);
  geometry::Ray ray;
  ray.origin = {0.75F, 0.25F, 1.0F};
  ray.direction = {0, 0, -1};
  const SurfacePoint p = surfaceAt(*s.mesh, s.materials, caster.closest(ray), {0, 0, -1});
  expectNear(p.bsdf.diffuse, dvec3(0.5));
  expectNear(p.position, {0.75, 0.25, 0.0});
  expectNear(p.bsdf.normal, {0, 0, 1});
}

TEST(SurfaceAt, TakesTheGreenOfTheRoughnessMap) {
  scene::Material m = test::matte(0.5);
  m.specular = 0.04;
  m.roughness = 0.8;
  m.roughness_image = std::make_shared<scene::Image>(scene::Image{1, 1, 3, {0.0F, 0.5F, 1.0F}});
  const scene::Scene s = test::Builder().quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m).scene();
  const geometry::Hit hit{.triangle = 0, .t = 1.0F, .u = 0.2F, .v = 0.2F};
  EXPECT_NEAR(surfaceAt(*s.mesh, s.materials, hit, {0, 0, -1}).bsdf.alpha, 0.16, 1e-12);
}

TEST(SurfaceAt, ReflectsOnTheSideOfTheRay) {
  const scene::Scene s =
      test::Builder().quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, test::matte(0.5)).scene();
  const geometry::Hit hit{.triangle = 0, .t = 1.0F, .u = 0.2F, .v = 0.2F};
  expectNear(surfaceAt(*s.mesh, s.materials, hit, {0, 0, 1}).bsdf.normal, {0, 0, -1});
}

TEST(SurfaceAt, GlassReflectsNothing) {
  scene::Material m = test::matte(0.5);
  m.specular = 0.04;
  m.glass = scene::Glass{};
  const scene::Scene s = test::Builder().quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m).scene();
  const geometry::Hit hit{.triangle = 0, .t = 1.0F, .u = 0.2F, .v = 0.2F};
  const SurfacePoint p = surfaceAt(*s.mesh, s.materials, hit, {0, 0, -1});
  EXPECT_EQ(albedo(p.bsdf, {0, 0, 1}), dvec3(0.0));
}

TEST(SurfaceAt, FallsBackToTheDefaultMaterial) {
  const scene::Scene s =
      test::Builder().quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, test::matte(0.9)).scene();
  const geometry::Hit hit{.triangle = 1, .t = 1.0F, .u = 0.2F, .v = 0.2F};
  EXPECT_EQ(surfaceAt(*s.mesh, {}, hit, {0, 0, -1}).bsdf.diffuse, dvec3(0.5));
}

}  // namespace
}  // namespace soffit::reference
