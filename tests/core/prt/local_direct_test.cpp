// SPDX-License-Identifier: MIT
#include "core/prt/local_direct.h"

#include "core/geometry/shapes.h"
#include "core/light/emitter_sampling.h"
#include "core/math/rng.h"
#include "core/sh/basis.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stop_token>
#include <utility>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

light::Emitter lamp(light::Shape shape, const dvec3& position,
                    light::DistributionKind kind = light::DistributionKind::lambertian) {
  light::Luminaire l;
  l.name = "lamp";
  l.shape = std::move(shape);
  l.position = position;
  l.flux = 1000.0;
  l.distribution.kind = kind;
  auto emitter = light::makeEmitter(l);
  EXPECT_TRUE(emitter.ok());
  return *emitter;
}

/// Points of a horizontal plane that look up, 16 x 16 in a square about `middle`.
light::Receivers plane(const vec3& middle, float side) {
  std::vector<vec3> positions;
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i) {
      const vec2 at = side * (vec2(i, j) / 15.0F - 0.5F);
      positions.push_back(middle + vec3(at, 0.0F));
    }
  }
  const std::vector<vec3> normals(positions.size(), vec3(0, 0, 1));
  return light::makeReceivers(positions, normals, 64);
}

std::vector<float> lit(const Surfaces& surfaces, const light::Receivers& receivers,
                       const LocalOptions& options, const light::Emitter& emitter) {
  const auto direct = LocalDirect::make(surfaces, receivers, options).value();
  std::vector<float> lux(receivers.slotCount());
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  direct->illuminate(emitter, lux, lit);
  return lux;
}

/// A speck far away: nothing is in the way.
std::shared_ptr<const Surfaces> nothing() {
  return Builder()
      .add(geometry::makeBox({900, 900, 900}, {901, 901, 901}), matte(vec3(0.5F)))
      .surfaces();
}

/// By random points on the luminaire, with nothing of the code under test.
sh::Coefficients sampled(const light::Emitter& e, const dvec3& p, int bands) {
  constexpr int kSamples = 1000000;
  Rng rng(5);
  sh::Coefficients sum(sh::coefficientCount(bands), 0.0);
  std::vector<double> basis(sum.size());
  for (int k = 0; k < kSamples; ++k) {
    const auto s = light::sampleByArea(e, {rng.uniformDouble(), rng.uniformDouble()});
    const dvec3 to = s.point - p;
    const double r2 = glm::dot(to, to);
    const dvec3 direction = to / std::sqrt(r2);
    const double intensity = e.kind == light::EmitterKind::point
                                 ? e.pointIntensity(-direction)
                                 : e.intensityPerArea(s.normal, -direction) / s.pdf_area;
    sh::evaluate(direction, bands, basis);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += intensity / r2 * basis[i] / kSamples;
  }
  return sum;
}

TEST(LuminaireLight, EveryShapeHasTheCoefficientsOfItsPoints) {
  using Kind = light::DistributionKind;
  const std::array<light::Emitter, 7> lamps = {
      lamp(light::Rectangle{0.6, 1.2}, {0.3, 0.2, 2.0}),
      lamp(light::Disk{0.4}, {0.3, 0.2, 1.5}),
      lamp(light::Sphere{0.2}, {0.3, -0.4, 1.2}),
      lamp(light::Tube{1.5, 0.02}, {0.3, 0.2, 1.5}),
      lamp(light::Polygon{{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.3}, {0, 1}}}, {0.3, 0.2, 1.7}),
      lamp(light::PointShape{}, {0.3, 0.2, 1.5}),
      lamp(light::PointShape{}, {0.3, 0.2, 1.5}, Kind::isotropic)};
  const dvec3 p(0.1, -0.3, 0.0);
  for (const light::Emitter& e : lamps) {
    const sh::Coefficients expected = sampled(e, p, 5);
    const sh::Coefficients found = LuminaireLight(e).at(p, 5);
    double most = 0.0;
    for (const double c : expected) most = std::max(most, std::abs(c));
    // A million points: 1e-3 of the largest; quadrature 5e-3.
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 6e-3 * most) << static_cast<int>(e.kind) << " " << i;
    }
  }
}

TEST(LuminaireLight, BehindAFlatLampIsDark) {
  const LuminaireLight light(lamp(light::Rectangle{0.6, 0.6}, {0, 0, 2}));
  EXPECT_TRUE(light.dark({0.1, 0.0, 2.5}));
  for (const double c : light.at({0.1, 0.0, 2.5}, 4)) EXPECT_EQ(c, 0.0);
  EXPECT_FALSE(light.around({0.1, 0.0, 2.5}, 4));
  EXPECT_FALSE(light.dark({0.1, 0.0, 1.5}));
}

TEST(LuminaireLight, GradientsServeReceiversNearBy) {
  const LuminaireLight light(lamp(light::Rectangle{0.6, 1.2}, {0.3, 0.2, 2.0}));
  const dvec3 p(0.1, -0.3, 0.0);
  const auto around = light.around(p, 5);
  ASSERT_TRUE(around);
  // Second order: half the offset, a quarter of the error.
  std::array<double, 2> error{};
  for (int k = 0; k < 2; ++k) {
    const dvec3 offset = (k == 0 ? 0.1 : 0.05) * glm::normalize(dvec3(1, 2, 0));
    const sh::Coefficients exact = light.at(p + offset, 5);
    const sh::Coefficients found = around->at(offset);
    double size = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      error[static_cast<std::size_t>(k)] += std::pow(found[i] - exact[i], 2);
      size += exact[i] * exact[i];
    }
    EXPECT_LT(std::sqrt(error[static_cast<std::size_t>(k)] / size), k == 0 ? 0.02 : 0.005);
  }
  EXPECT_NEAR(std::sqrt(error[0] / error[1]), 4.0, 0.8);
}

// Fujita & Kanai's plane under a lamp that shines alike in all directions: cos / d^2.
TEST(LocalDirect, APlaneUnderAnIsotropicLampFollowsCosineOverDistanceSquared) {
  const light::Emitter e =
      lamp(light::PointShape{}, {0, 0, 1.0}, light::DistributionKind::isotropic);
  const light::Receivers receivers = plane(vec3(0), 6.0F);
  const double intensity = 1000.0 / (4.0 * kPi);
  for (const LocalMethod method : {LocalMethod::harmonics, LocalMethod::cubes}) {
    std::array<double, 2> worst{};
    for (int k = 0; k < 2; ++k) {
      const std::vector<float> lux =
          lit(*nothing(), receivers, {.method = method, .bands = k == 0 ? 5 : 9}, e);
      for (std::size_t s = 0; s < lux.size(); ++s) {
        const vec3 p = receivers.position(s);
        const double d2 = 1.0 + double{p.x} * p.x + double{p.y} * p.y;
        const double off = std::abs(double{lux[s]} - intensity / (d2 * std::sqrt(d2)));
        worst[static_cast<std::size_t>(k)] =
            std::max(worst[static_cast<std::size_t>(k)], off / intensity);
      }
    }
    EXPECT_LT(worst[0], 0.06) << static_cast<int>(method);  // of the peak, five bands
    EXPECT_LT(worst[1], 0.02) << static_cast<int>(method);
  }
}

TEST(LocalDirect, APanelOverAPlaneIsNearItsClosedForm) {
  const light::Emitter e = lamp(light::Rectangle{0.6, 1.2}, {0.4, 0.2, 2.0});
  const light::Receivers receivers = plane(vec3(0), 3.0F);
  for (const LocalMethod method : {LocalMethod::harmonics, LocalMethod::cubes}) {
    const std::vector<float> lux = lit(*nothing(), receivers, {.method = method, .bands = 7}, e);
    double error = 0.0;
    double size = 0.0;
    for (std::size_t s = 0; s < lux.size(); ++s) {
      const double exact =
          light::unoccludedIlluminance(e, dvec3(receivers.position(s)), dvec3(0, 0, 1));
      error += std::pow(double{lux[s]} - exact, 2);
      size += exact * exact;
    }
    EXPECT_LT(std::sqrt(error / size), 0.02) << static_cast<int>(method);
  }
}

TEST(LocalDirect, WhatStandsInTheWayShades) {
  // A wall between the lamp and the receivers, 40 cm before them.
  const auto wall =
      Builder()
          .add(geometry::makeBox({0.5F, -3.0F, -0.1F}, {0.6F, 3.0F, 3.0F}), matte(vec3(0.5F)))
          .surfaces();
  const light::Emitter e = lamp(light::Sphere{0.1}, {3.0, 0.0, 1.0});
  const light::Receivers receivers = plane(vec3(0), 0.3F);
  const std::vector<float> open = lit(*nothing(), receivers, {}, e);
  const std::vector<float> flags = lit(*wall, receivers, {}, e);
  const std::vector<float> cube = lit(*wall, receivers, {.method = LocalMethod::cubes}, e);
  for (std::size_t s = 0; s < open.size(); ++s) {
    EXPECT_GT(open[s], 1.0F);
    EXPECT_LT(flags[s], 0.25F * open[s]);  // a wall's edge in five bands is soft
    EXPECT_EQ(cube[s], 0.0F);
  }
}

TEST(LocalDirect, WallsBehindTheLampDoNotShadeWithinReach) {
  const auto room = Builder()
                        .add(geometry::makeBox({-2, -2, 0}, {2, 2, 3}), matte(vec3(0.5F)))
                        .surfaces({vec3(0, 0, 1)});
  const light::Emitter e = lamp(light::Rectangle{0.6, 0.6}, {0, 0, 2.9});
  const light::Receivers receivers = plane(vec3(0, 0, 0.8F), 1.0F);
  const std::vector<float> near = lit(*room, receivers, {.bands = 6, .reach = 1.0F}, e);
  const std::vector<float> distant = lit(*room, receivers, {.bands = 6, .reach = 100.0F}, e);
  const std::vector<float> cube =
      lit(*room, receivers, {.method = LocalMethod::cubes, .bands = 6, .cube_side = 32}, e);
  for (std::size_t s = 0; s < near.size(); ++s) {
    const double exact =
        light::unoccludedIlluminance(e, dvec3(receivers.position(s)), dvec3(0, 0, 1));
    EXPECT_NEAR(near[s], exact, 0.06 * exact);
    EXPECT_NEAR(cube[s], exact, 0.06 * exact);
    EXPECT_EQ(distant[s], 0.0F) << "as for light from outside";
  }
}

TEST(LocalDirect, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  const auto made =
      LocalDirect::make(*nothing(), plane(vec3(0), 1.0F), {}, Job{nullptr, stop.get_token()});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().what, "cancelled");
}

}  // namespace
}  // namespace soffit::prt
