// SPDX-License-Identifier: MIT
#include "core/light/prepared_light.h"

#include "core/geometry/mesh.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace soffit::light {
namespace {

Emitter emitterOf(const Shape& shape, const dvec3& position = dvec3(0, 0, 2.5),
                  const dvec3& rotation_deg = dvec3(0)) {
  Luminaire l;
  l.shape = shape;
  l.position = position;
  l.rotation_deg = rotation_deg;
  l.flux = 1000.0;
  const auto e = makeEmitter(l);
  EXPECT_TRUE(e.ok());
  return *e;
}

/// Area of the set bits of all masks of a level.
double maskArea(const PreparedLight& light, int level) {
  double area = 0.0;
  for (const MaskLight& m : light.masks(level)) {
    int bits = 0;
    for (const std::uint32_t row : m.outline) bits += std::popcount(row);
    area += static_cast<double>(glm::length(glm::cross(m.u, m.v))) * bits / 512.0;
  }
  return area;
}

TEST(PreparedLight, MasksCoverTheOutlineAtEveryLevel) {
  const Polygon l_shape{{{0, 0}, {0.9, 0}, {0.9, 0.3}, {0.3, 0.3}, {0.3, 0.9}, {0, 0.9}}};
  for (const Shape& shape : {Shape(Rectangle{1.2, 0.3}), Shape(Disk{0.4}), Shape(l_shape)}) {
    const Emitter e = emitterOf(shape, {1, 2, 2.5}, {20, 30, 40});
    const PreparedLight light(e);
    EXPECT_EQ(light.form(), PreparedLight::Form::planar);
    std::size_t before = 0;
    for (int level = 0; level < PreparedLight::kLevels; ++level) {
      EXPECT_GT(light.masks(level).size(), before);
      before = light.masks(level).size();
      // Samples along the rim: 512 of them whole, finer with each level.
      EXPECT_NEAR(maskArea(light, level), e.area, 0.02 * e.area) << level;
      for (const MaskLight& m : light.masks(level))
        EXPECT_NEAR(glm::dot(m.normal, vec3(e.normal)), 1.0F, 1e-5F);
    }
  }
}

TEST(PreparedLight, CellsShrinkUntilTheyAreHalfTheDistance) {
  const PreparedLight light(emitterOf(Rectangle{1.2, 1.2}));
  int last = PreparedLight::kLevels;
  for (const float distance : {0.01F, 0.1F, 0.3F, 0.5F, 1.0F, 5.0F, 100.0F}) {
    const int level = light.maskLevel(distance);
    EXPECT_LE(level, last);
    last = level;
    const MaskLight m = light.masks(level)[0];
    const float diagonal = 0.25F * glm::length(m.u + m.v);
    if (level + 1 == PreparedLight::kLevels) continue;  // the finest there is
    EXPECT_LE(diagonal, 0.5F * distance * 1.001F);
  }
  EXPECT_EQ(light.maskLevel(100.0F), 0);
}

TEST(PreparedLight, SamplesWeighTheArea) {
  Luminaire l;
  l.shape = PointShape{};
  l.flux = 100.0;
  const PreparedLight point(*makeEmitter(l));
  for (int level = 0; level < PreparedLight::kSampleLevels; ++level) {
    EXPECT_EQ(point.samples(level).size(), 1U);
    EXPECT_EQ(point.samples(level).weight[0], 1.0F);
  }
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = {{0, 1, 2}};
  MeshShape shape;
  shape.mesh = mesh;
  const Emitter e = emitterOf(shape);
  const PreparedLight light(e);
  EXPECT_EQ(light.form(), PreparedLight::Form::points);
  for (int level = 0; level < PreparedLight::kSampleLevels; ++level) {
    const PointLightSamples& s = light.samples(level);
    EXPECT_EQ(s.size(), std::size_t{1} << (2 * level));
    double weight = 0.0;
    for (const float w : s.weight) weight += static_cast<double>(w);
    EXPECT_NEAR(weight, e.area, 1e-5 * e.area);
  }
  EXPECT_GE(light.sampleLevel(0.1F), light.sampleLevel(10.0F));
}

TEST(PreparedLight, ABallFacesTheEyeWithTheConeOfItsTangents) {
  const PreparedLight light(emitterOf(Sphere{0.5}, {1, 2, 3}));
  EXPECT_EQ(light.form(), PreparedLight::Form::facing);
  const vec3 eye(1, 2, 0);
  const MaskLight m = light.facing(eye);
  EXPECT_NEAR(m.normal.z, -1.0F, 1e-5F);
  // Half angle asin(1/6): the rim lies 0.5 sin(1/6) nearer, its radius is 0.5 cos of it.
  int bits = 0;
  for (const std::uint32_t row : m.outline) bits += std::popcount(row);
  const double rim = 0.5 * std::sqrt(1.0 - 1.0 / 36.0);
  const double area = static_cast<double>(glm::length(glm::cross(m.u, m.v))) * bits / 512.0;
  EXPECT_NEAR(area, std::numbers::pi * rim * rim, 0.02);  // 512 samples of a circle
  EXPECT_NEAR(m.origin.z, 3.0 - 0.5 / 6.0, 1e-5);
}

TEST(PreparedLight, ATubeFacesTheEyeWithARectangle) {
  const PreparedLight light(emitterOf(Tube{1.2, 0.05}, {0, 0, 2}));
  const MaskLight m = light.facing({0, 0, 0});
  EXPECT_NEAR(glm::length(m.u), 1.2F, 1e-5F);
  EXPECT_NEAR(glm::length(m.v), 0.1F, 1e-3F);
  EXPECT_NEAR(m.normal.z, -1.0F, 1e-5F);
}

TEST(PreparedLight, SixteenAtOnceAreEachOnTheirOwn) {
  const Polygon l_shape{{{0, 0}, {0.9, 0}, {0.9, 0.3}, {0.3, 0.3}, {0.3, 0.9}, {0, 0.9}}};
  for (const Shape& shape : {Shape(Rectangle{1.2, 0.3}), Shape(Disk{0.4}), Shape(l_shape),
                             Shape(Sphere{0.3}), Shape(Tube{1.2, 0.02}), Shape(PointShape{})}) {
    const Emitter e = emitterOf(shape, {0.2, 0.1, 2}, {10, 20, 30});
    const PreparedLight light(e);
    std::array<std::array<float, 16>, 6> v{};
    for (std::size_t i = 0; i < 16; ++i) {
      // On the floor, on walls whose horizon cuts the light, and behind it.
      v[0][i] = -2.0F + 0.27F * static_cast<float>(i);
      v[1][i] = 0.3F;
      v[2][i] = i < 8 ? 0.0F : 2.0F + 0.1F * static_cast<float>(i % 4);
      v[3][i] = i % 2 == 0 ? 0.0F : 1.0F;
      v[5][i] = i % 2 == 0 ? 1.0F : 0.0F;
    }
    double lux[16];
    light.unoccluded({v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), v[5].data()},
                     2.0F, lux);
    for (std::size_t i = 0; i < 16; ++i) {
      const double expected = unoccludedIlluminance(e, dvec3(v[0][i], v[1][i], v[2][i]),
                                                    dvec3(v[3][i], v[4][i], v[5][i]));
      EXPECT_NEAR(lux[i], expected, 1e-9 * (std::abs(expected) + 1000.0))
          << shape.index() << ' ' << i;
    }
  }
}

TEST(PreparedLight, ANarrowBeamFromADiskIsAsWideAsItIs) {
  // A spot whose intensity falls to 1/1000 within 30 degrees, seen about its beam's edge from two
  // metres and more, where one point stands for its disk of 4 cm.
  auto table = std::make_shared<photometry::IntensityDistribution>();
  table->c_deg = {0.0};
  for (int gamma = 0; gamma <= 90; ++gamma) {
    table->gamma_deg.push_back(gamma);
    table->candela.push_back(1000.0 * std::exp(-std::pow(gamma / 11.5, 2.0)));
  }
  Luminaire spot;
  spot.position = {0.0, 0.0, 2.5};
  spot.distribution = {DistributionKind::ies, "spot.ies", table};
  for (const Shape& shape : {Shape(Disk{0.04}), Shape(Sphere{0.04}), Shape(Tube{0.08, 0.02})}) {
    spot.shape = shape;
    const Emitter e = *makeEmitter(spot);
    const PreparedLight light(e);
    std::array<std::array<float, 16>, 6> v{};
    for (std::size_t i = 0; i < 16; ++i) {
      const float angle = 0.3927F * static_cast<float>(i);
      v[0][i] = 1.2F * std::cos(angle);
      v[1][i] = 1.2F * std::sin(angle);
      v[5][i] = 1.0F;
    }
    EXPECT_EQ(light.samples(light.sampleLevel(2.5F)).size(), 1U);
    double lux[16];
    light.unoccluded({v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), v[5].data()},
                     2.5F, lux);
    for (std::size_t i = 0; i < 16; ++i) {
      const double exact = unoccludedIlluminance(e, {v[0][i], v[1][i], 0.0}, {0.0, 0.0, 1.0});
      // What is left is of second order in size / (distance x width of the beam), 0.04 / 0.5.
      EXPECT_NEAR(lux[i] / exact, 1.0, 0.01) << shape.index() << ' ' << i;
    }
  }
}

/// A closed ball with bumps, about 2 n^2 triangles, of some 0.25 m in radius.
std::shared_ptr<geometry::Mesh> bumpyBall(int n) {
  auto mesh = std::make_shared<geometry::Mesh>();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double theta = kPi * i / n;
      const double phi = 2 * kPi * j / n;
      const double r = 0.25 * (1 + 0.25 * std::sin(3 * theta) * std::sin(4 * phi));
      mesh->positions.emplace_back(r * std::sin(theta) * std::cos(phi),
                                   r * std::sin(theta) * std::sin(phi), r * std::cos(theta));
    }
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i * n + j % n); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i > 0) mesh->triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + 1 < n) mesh->triangles.emplace_back(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
    }
  }
  return mesh;
}

TEST(PreparedLight, LargeMeshesAgreeWithTheSumOfTheirTriangles) {
  for (const int n : {12, 20, 54}) {
    Luminaire l;
    MeshShape shape;
    shape.mesh = bumpyBall(n);
    l.shape = shape;
    l.flux = 1000.0;
    const auto e = makeEmitter(l);
    ASSERT_TRUE(e.ok());
    const PreparedLight light(*e);
    for (const float distance : {0.36F, 0.6F, 1.0F, 2.0F, 5.0F}) {
      Rng rng(3);
      double square = 0.0;
      for (int g = 0; g < 10; ++g) {
        std::array<std::array<float, 16>, 6> v{};
        const vec3 dir = uniformSphere(rng.uniform(), rng.uniform());
        float nearest = 1e30F;
        for (std::size_t i = 0; i < 16; ++i) {
          const vec3 p = distance * dir + 0.05F * uniformSphere(rng.uniform(), rng.uniform());
          const vec3 m = glm::normalize(0.7F * uniformSphere(rng.uniform(), rng.uniform()) - dir);
          for (int k = 0; k < 3; ++k) {
            v[static_cast<std::size_t>(k)][i] = p[k];
            v[static_cast<std::size_t>(3 + k)][i] = m[k];
          }
          nearest = std::min(nearest, std::sqrt(e->bounds.distanceSquared(p)));
        }
        const MaskReceivers r{v[0].data(), v[1].data(), v[2].data(),
                              v[3].data(), v[4].data(), v[5].data()};
        std::array<double, 16> lux{};
        light.unoccluded(r, nearest, lux.data());
        for (std::size_t i = 0; i < 16; ++i) {
          const double expected = unoccludedIlluminance(*e, dvec3(v[0][i], v[1][i], v[2][i]),
                                                        dvec3(v[3][i], v[4][i], v[5][i]));
          square += std::pow(lux[i] / expected - 1.0, 2);
        }
      }
      // Truncation: a triangle as a point errs by some (extent/distance)^2/50, of either sign.
      EXPECT_LT(std::sqrt(square / 160.0), 3e-4) << n << ' ' << distance;
    }
  }
}

}  // namespace
}  // namespace soffit::light
