// SPDX-License-Identifier: MIT
#include "core/render/probe_reflections.h"

#include "core/glossy/lobe_shape.h"
#include "core/math/rng.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265F;

Box room() {
  Box box;
  box.add(vec3(0.0F));
  box.add(vec3(4.0F, 3.0F, 2.5F));
  return box;
}

std::shared_ptr<const glossy::ReflectionLevels> levels() {
  static const auto shared = std::make_shared<const glossy::ReflectionLevels>(32);
  return shared;
}

/// Walls of one colour; or the wall x = 4 white and all else black.
std::unique_ptr<ViewScene> roomScene(bool one_wall) {
  SceneBuilder builder;
  const auto dark = builder.addMaterial({.diffuse = dvec3(one_wall ? 0.0 : 0.5)});
  const auto white = builder.addMaterial({.diffuse = dvec3(one_wall ? 0.8 : 0.5)});
  builder.addQuad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, dark);
  builder.addQuad({0, 0, 2.5F}, {0, 3, 0}, {4, 0, 0}, dark);
  builder.addQuad({0, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, dark);
  builder.addQuad({0, 0, 0}, {0, 0, 2.5F}, {4, 0, 0}, dark);
  builder.addQuad({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5F}, dark);
  builder.addQuad({4, 0, 0}, {0, 0, 2.5F}, {0, 3, 0}, white);
  return builder.build();
}

SurfaceSample floorAt(const vec3& p, const vec3& eye) {
  SurfaceSample at;
  at.point.position = p;
  at.to_eye = glm::normalize(eye - p);
  return at;
}

TEST(ProbeReflections, UniformLightGivesTheReflectance) {
  const auto scene = roomScene(false);
  const auto probes = probeGrid(*scene, room(), 2.0F);
  ASSERT_FALSE(probes.empty());
  ProbeReflections reflections(*scene, probes, room(), levels());
  const SurfaceSample at = floorAt({1, 1, 0}, {3, 2, 1.5F});
  EXPECT_EQ(reflections.reflected(at, 0.04F, 0.1F), vec3(0.0F));  // no light yet
  reflections.light(EvenLight(vec3(100.0F)));
  const auto cosine = static_cast<double>(at.to_eye.z);
  for (const float alpha : {0.0F, 0.1F, 0.5F}) {
    const double expected =
        0.5 * 100.0 / kPi * glossy::lobeShape(cosine, static_cast<double>(alpha)).reflectance(0.04);
    EXPECT_NEAR(static_cast<double>(reflections.reflected(at, 0.04F, alpha).y), expected,
                1e-4 * expected);
  }
  // Twice the light, twice the picture; no ray.
  const float before = reflections.reflected(at, 0.04F, 0.1F).y;
  reflections.light(EvenLight(vec3(200.0F)));
  EXPECT_NEAR(reflections.reflected(at, 0.04F, 0.1F).y, 2.0F * before, 1e-4F * before);
}

TEST(ProbeReflections, AWallIsReflectedWhereItIs) {
  // Mirror-like floor: looking toward +x the white wall appears up to its height and no farther.
  const auto scene = roomScene(true);
  const std::vector<vec3> probes{{2.0F, 1.5F, 1.25F}};
  ProbeReflections reflections(*scene, probes, room(), levels());
  reflections.light(EvenLight(vec3(kPiF)));
  Rng rng(3);
  int wrong = 0;
  constexpr int kPoints = 300;
  for (int k = 0; k < kPoints; ++k) {
    const vec3 p(0.3F + 3.4F * rng.uniform(), 0.3F + 2.4F * rng.uniform(), 0.0F);
    const vec3 eye(0.2F, 1.5F, 0.4F + 1.8F * rng.uniform());
    const SurfaceSample at = floorAt(p, eye);
    const vec3 mirror(-at.to_eye.x, -at.to_eye.y, at.to_eye.z);
    const auto hit = scene->caster().closest(geometry::Ray{p + vec3(0, 0, 1e-4F), 0.0F, mirror});
    const bool white = scene->material(hit.triangle).diffuse.y > 0.5F;
    const float found = reflections.reflected(at, 0.99F, 0.0F).y;
    if (white != (found > 0.4F)) ++wrong;
  }
  // Only near the wall's edges, where a texel (0.06 rad) straddles them.
  EXPECT_LT(wrong, kPoints / 20);
}

TEST(ProbeGrid, KeepsClearOfWalls) {
  const auto scene = roomScene(false);
  for (const vec3& p : probeGrid(*scene, room(), 1.0F)) {
    EXPECT_TRUE(room().contains(p));
    EXPECT_GT(std::min({p.x, p.y, p.z, 4 - p.x, 3 - p.y, 2.5F - p.z}), 0.15F);
  }
}

}  // namespace
}  // namespace soffit::render
