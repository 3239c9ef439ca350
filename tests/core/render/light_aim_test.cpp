// SPDX-License-Identifier: MIT
#include "core/render/light_aim.h"

#include "core/math/sampling.h"
#include "core/render/emitter_hits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

light::Emitter make(const light::Shape& shape, const dvec3& rotation = dvec3(0.0)) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  l.position = {0.2, 0.1, 2.0};
  l.rotation_deg = rotation;
  l.flux = 1000.0;
  if (std::holds_alternative<light::PointShape>(shape))
    l.distribution.kind = light::DistributionKind::isotropic;
  return light::makeEmitter(l).value();
}

/// Solid angle of what is seen of a luminaire: mean of 1 / pdf over the aims that see it.
double solidAngle(const light::Emitter& e, const dvec3& origin) {
  const std::vector<light::Emitter> one{e};
  const EmitterHits hits(one);
  double sum = 0.0;
  constexpr std::uint32_t kPoints = 4000;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const LightAim aim = aimAt(e, origin, vec2(r2Sequence(i)));
    if (glm::dot(aim.normal, aim.direction) >= 0.0) continue;  // a far side
    const EmitterHit hit = hits.closest({.origin = vec3(origin), .direction = vec3(aim.direction)});
    if (hit.valid()) {
      EXPECT_NEAR(static_cast<double>(hit.t), aim.distance, 1e-3);
      EXPECT_NEAR(aimPdf(e, origin, aim.direction, aim.distance, aim.normal), aim.pdf,
                  1e-9 * aim.pdf);
    }
    sum += 1.0 / aim.pdf / kPoints;
  }
  return sum;
}

TEST(LightAim, FillsTheSolidAngleOfASphere) {
  const double sin2 = 0.3 * 0.3 / (0.04 + 0.01 + 4.0);
  // Uniform in the cone: exact but for rounding.
  EXPECT_NEAR(solidAngle(make(light::Sphere{0.3}), dvec3(0.0)), 2 * kPi * (1 - std::sqrt(1 - sin2)),
              1e-9);
}

TEST(LightAim, FillsTheSolidAngleOfADisk) {
  // On the axis.
  EXPECT_NEAR(solidAngle(make(light::Disk{0.5}), {0.2, 0.1, 0.0}),
              2 * kPi * (1 - 2.0 / std::sqrt(4.25)),
              1e-4);  // truncation of 4000 low-discrepancy points
}

TEST(LightAim, FillsTheSolidAngleOfATube) {
  // Far away a tube is its silhouette: length times diameter.
  const dvec3 eye(0.2, 0.1, -30.0);
  EXPECT_NEAR(solidAngle(make(light::Tube{1.0, 0.05}), eye), 0.1 / (32.0 * 32.0),
              0.01 * 0.1 / 1024.0);
}

TEST(LightAim, FindsNoSphereFromInside) {
  EXPECT_EQ(aimAt(make(light::Sphere{0.3}), {0.2, 0.1, 1.9}, {0.5F, 0.5F}).distance, 0.0);
}

TEST(LightAim, PointsGiveNormalIlluminance) {
  const LightAim aim = aimAt(make(light::PointShape{}), {0.2, 0.1, 0.0}, {0.5F, 0.5F});
  EXPECT_EQ(aim.pdf, 0.0);
  EXPECT_NEAR(aim.intensity.y, 1000.0 / (4 * kPi) / 4.0, 1e-4);
}

}  // namespace
}  // namespace soffit::render
