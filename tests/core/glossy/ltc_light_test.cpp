// SPDX-License-Identifier: MIT
#include "core/glossy/ltc_light.h"

#include "core/glossy/ggx.h"
#include "core/glossy/lobe_shape.h"
#include "core/light/emitter.h"
#include "core/light/polygon_irradiance.h"
#include "core/math/sampling.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::glossy {
namespace {

const dvec3 kUp(0.0, 0.0, 1.0);

/// A rectangle about `center` that faces `toward`, counter-clockwise seen from there.
std::vector<dvec3> rectangle(const dvec3& center, const dvec3& toward, double a, double b,
                             double turn) {
  dvec3 t(0.0), s(0.0);
  orthonormalBasis(toward, t, s);
  const dvec3 x = std::cos(turn) * t + std::sin(turn) * s;
  const dvec3 y = glm::cross(toward, x);
  return {center - a * x - b * y, center + a * x - b * y, center + a * x + b * y,
          center - a * x + b * y};
}

/// The share of the GGX lobe that the rectangle fills, by its points.
double summedShare(const std::vector<dvec3>& r, const dvec3& wo, double alpha) {
  constexpr int kSide = 80;
  const dvec3 u = r[1] - r[0];
  const dvec3 v = r[3] - r[0];
  const dvec3 n = glm::cross(u, v) / static_cast<double>(kSide * kSide);
  double sum = 0.0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const dvec3 p = r[0] + (i + 0.5) / kSide * u + (j + 0.5) / kSide * v;
      const double d2 = glm::dot(p, p);
      const dvec3 wi = p / std::sqrt(d2);
      sum += ggxLobe(wo, wi, alpha) * std::max(0.0, -glm::dot(n, wi)) / d2;
    }
  }
  const LobeShape shape = integrateLobe(wo.z, alpha);
  return sum / (shape.scale + shape.bias);
}

TEST(LtcLight, AHemisphereFullOfLightFillsTheLobe) {
  const std::vector<dvec3> sky = rectangle(dvec3(0, 0, 1e-4), -kUp, 1.0, 1.0, 0.3);
  for (const double cosine : {0.2, 0.6, 1.0}) {
    for (const double alpha : {0.05, 0.3}) {
      const dvec3 eye(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      // What the fit has below the horizon is cut off: stated as 0.1 at grazing angles.
      const double share = LobeFrame(dvec3(0.0), kUp, eye, alpha).share(sky);
      EXPECT_LT(share, 1.0 + 1e-9);
      EXPECT_GT(share, cosine < 0.5 ? 0.9 : 0.95);
    }
  }
}

TEST(LtcLight, SharesAddUp) {
  const dvec3 eye = glm::normalize(dvec3(0.5, 0.2, 0.8));
  const LobeFrame frame(dvec3(0.0), kUp, eye, 0.2);
  const std::vector<dvec3> whole{dvec3(-2, 1, 1), dvec3(0, 1, 1), dvec3(0, -1, 1),
                                 dvec3(-2, -1, 1)};
  const std::vector<dvec3> left{dvec3(-2, 1, 1), dvec3(-1, 1, 1), dvec3(-1, -1, 1),
                                dvec3(-2, -1, 1)};
  const std::vector<dvec3> right{dvec3(-1, 1, 1), dvec3(0, 1, 1), dvec3(0, -1, 1),
                                 dvec3(-1, -1, 1)};
  EXPECT_GT(frame.share(whole), 0.1);
  EXPECT_NEAR(frame.share(whole), frame.share(left) + frame.share(right), 1e-12);
  const std::vector<dvec3> back(whole.rbegin(), whole.rend());
  EXPECT_EQ(frame.share(back), 0.0);
}

TEST(LtcLight, BelowTheHorizonThereIsNothing) {
  const dvec3 eye = glm::normalize(dvec3(0.9, 0.0, 0.1));
  const LobeFrame frame(dvec3(0.0), kUp, eye, 0.5);
  const std::vector<dvec3> wall = rectangle(dvec3(-1, 0, 0), dvec3(1, 0, 0), 0.5, 0.5, 0.0);
  std::vector<dvec3> upper, lower;
  for (const dvec3& corner : wall) {
    upper.push_back({corner.x, corner.y, std::max(0.0, corner.z)});
    lower.push_back({corner.x, corner.y, std::min(0.0, corner.z)});
  }
  EXPECT_GT(frame.share(wall), 0.05);
  EXPECT_NEAR(frame.share(wall), frame.share(upper), 1e-12);
  EXPECT_NEAR(frame.share(lower), 0.0, 1e-15);
}

TEST(LtcLight, HighlightsAgreeWithNumericalIntegration) {
  Rng rng(12);
  for (const double roughness : {0.25, 0.4, 0.5, 0.7, 1.0}) {
    for (const double angle : {0.0, 30.0, 45.0, 60.0, 70.0, 80.0}) {
      const double alpha = roughness * roughness;
      const dvec3 eye(std::sin(radians(angle)), 0.0, std::cos(radians(angle)));
      const LobeFrame frame(dvec3(0.0), kUp, eye, alpha);
      double squares = 0.0;
      constexpr int kLights = 24;
      for (int k = 0; k < kLights; ++k) {
        const dvec3 mirror(-eye.x, 0.0, eye.z);
        dvec3 direction = glm::normalize(mirror + (0.1 + alpha) * randomDirection(rng));
        direction.z = std::max(direction.z, 0.05);
        const dvec3 center = (0.5 + 2.5 * rng.uniformDouble()) * glm::normalize(direction);
        dvec3 toward = glm::normalize(-center + 0.5 * glm::length(center) * randomDirection(rng));
        const auto light = rectangle(center, toward, 0.15 + 0.85 * rng.uniformDouble(),
                                     0.15 + 0.85 * rng.uniformDouble(), rng.uniformDouble());
        const double error = frame.share(light) - summedShare(light, eye, alpha);
        squares += error * error;
      }
      const double rms = std::sqrt(squares / kLights);
      EXPECT_LT(rms, angle <= 45.0   ? 0.01
                     : angle <= 60.0 ? 0.02
                                     : 0.065)
          << roughness << ' ' << angle;
    }
  }
}

light::Emitter emitterOf(const light::Shape& shape, const dvec3& position) {
  light::Luminaire luminaire;
  luminaire.shape = shape;
  luminaire.position = position;
  luminaire.flux = 1000.0;
  return *light::makeEmitter(luminaire);
}

/// E / L from outlines, which Lambert's formula knows for the shape itself.
double irradiance(const light::Emitter& e, const dvec3& p, const dvec3& n) {
  double sum = 0.0;
  for (const auto& outline : facingOutlines(e, p)) sum += light::polygonIrradiance(outline, p, n);
  return sum;
}

TEST(FacingOutlines, IrradianceIsThatOfTheShape) {
  const dvec3 p(0.3, 0.2, 0.0);
  const dvec3 at(0.0, 0.0, 2.0);
  const light::Emitter disk = emitterOf(light::Disk{0.3}, at);
  // 24 corners of the same area: second moments differ by 0.1 %, times (radius / distance)^2.
  EXPECT_NEAR(irradiance(disk, p, kUp) / light::diskIrradiance(at, -kUp, 0.3, p, kUp), 1.0, 1e-3);
  const light::Emitter sphere = emitterOf(light::Sphere{0.3}, at);
  EXPECT_NEAR(irradiance(sphere, p, kUp) / light::sphereIrradiance(at, 0.3, p, kUp), 1.0, 1e-3);
  const light::Emitter tube = emitterOf(light::Tube{1.2, 0.02}, at);
  // The ends are straight instead of round: radius / length.
  EXPECT_NEAR(
      irradiance(tube, p, kUp) / light::tubeIrradiance(at, dvec3(1, 0, 0), 0.6, 0.02, p, kUp), 1.0,
      0.02);
  const light::Emitter panel = emitterOf(light::Rectangle{0.6, 0.6}, at);
  EXPECT_NEAR(irradiance(panel, p, kUp), light::polygonIrradiance(panel.outline, p, kUp), 1e-12);
}

TEST(FacingOutlines, NothingFromBehindOrInside) {
  const dvec3 at(0.0, 0.0, 2.0);
  EXPECT_TRUE(facingOutlines(emitterOf(light::Disk{0.3}, at), {0, 0, 3}).empty());
  EXPECT_TRUE(facingOutlines(emitterOf(light::Sphere{0.3}, at), {0, 0, 2.1}).empty());
  EXPECT_TRUE(facingOutlines(emitterOf(light::Tube{1.0, 0.3}, at), {0, 0, 2.1}).empty());
}

}  // namespace
}  // namespace soffit::glossy
