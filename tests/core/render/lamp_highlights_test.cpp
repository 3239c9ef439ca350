// SPDX-License-Identifier: MIT
#include "core/render/lamp_highlights.h"

#include "core/render/microfacet.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

light::Luminaire lamp(const light::Shape& shape, const dvec3& position) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  l.position = position;
  l.flux = 1000.0;
  return l;
}

SurfaceSample originSeenFrom(const vec3& eye) {
  SurfaceSample at;
  at.to_eye = glm::normalize(eye);
  return at;
}

/// The panel of 1 m x 1 m at height 2 through the lobe at the origin, point by point; from x0 on.
double summed(const vec3& eye, float f0, float alpha, double x0 = -0.5) {
  const vec3 wo = glm::normalize(eye);
  constexpr int kSide = 200;
  double sum = 0.0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const dvec3 p((i + 0.5) / kSide - 0.5, (j + 0.5) / kSide - 0.5, 2.0);
      if (p.x < x0) continue;
      const double d2 = glm::dot(p, p);
      const dvec3 wi = p / std::sqrt(d2);
      sum += static_cast<double>(ggxReflection(wo, vec3(wi), f0, alpha)) * wi.z / d2;
    }
  }
  return sum / (kSide * kSide) * 1000.0 / kPi;
}

TEST(LampHighlights, PanelEqualsTheSumOverItsPoints) {
  SceneBuilder builder;
  builder.addQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, builder.addMaterial({}));
  const auto scene = builder.build({lamp(light::Rectangle{1, 1}, {0, 0, 2})});
  for (const float alpha : {0.0625F, 0.16F, 0.4F}) {
    for (const vec3& eye : {vec3(0.1F, 0, 1), vec3(0.5F, 0.3F, 1)}) {
      const double exact = summed(eye, 0.1F, alpha);
      const vec3 found = lampHighlights(*scene, originSeenFrom(eye), 0.1F, alpha);
      // The lobe's fit (0.01 of its weight, ltc_light.h) and Fresnel taken as the lobe's mean.
      const double full = 1000.0 / kPi * 0.1;
      EXPECT_NEAR(static_cast<double>(found.y), exact, 0.01 * full + 0.02 * exact) << alpha;
    }
  }
}

TEST(LampHighlights, AScreenHidesItsShare) {
  // A screen just below the panel covers x < 0 of it.
  SceneBuilder builder;
  const auto m = builder.addMaterial({});
  builder.addQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, m);
  builder.addQuad({-3, -3, 1.99F}, {3, 0, 0}, {0, 6, 0}, m);
  const auto scene = builder.build({lamp(light::Rectangle{1, 1}, {0, 0, 2})});
  const vec3 eye(0.2F, 0, 1);
  const double share = summed(eye, 0.1F, 0.2F, 0.0) / summed(eye, 0.1F, 0.2F);
  SceneBuilder open;
  open.addQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, open.addMaterial({}));
  const auto free = open.build({lamp(light::Rectangle{1, 1}, {0, 0, 2})});
  const vec3 with = lampHighlights(*scene, originSeenFrom(eye), 0.1F, 0.2F, {.shadow_rays = 256});
  const vec3 without = lampHighlights(*free, originSeenFrom(eye), 0.1F, 0.2F);
  EXPECT_NEAR(static_cast<double>(with.y / without.y), share, 0.02);  // 256 rays, low discrepancy
}

TEST(LampHighlights, PointsShowTheLobeItselfAndMirrorsNothing) {
  SceneBuilder builder;
  builder.addQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, builder.addMaterial({}));
  const auto scene = builder.build({lamp(light::PointShape{}, {0.3, 0, 2})});
  const vec3 eye = glm::normalize(vec3(-0.2F, 0, 1));
  const vec3 wi = glm::normalize(vec3(0.3F, 0, 2));
  const double lux = 1000.0 / kPi * static_cast<double>(wi.z) / 4.09;  // I0 cos gamma / r^2
  const vec3 found = lampHighlights(*scene, originSeenFrom(eye), 0.04F, 0.2F);
  EXPECT_NEAR(static_cast<double>(found.y),
              lux * static_cast<double>(ggxReflection(eye, wi, 0.04F, 0.2F)), 1e-3);
  EXPECT_EQ(lampHighlights(*scene, originSeenFrom(eye), 0.04F, 0.0F), vec3(0.0F));
  EXPECT_EQ(lampHighlights(*scene, originSeenFrom(eye), 0.0F, 0.2F), vec3(0.0F));
}

}  // namespace
}  // namespace soffit::render
