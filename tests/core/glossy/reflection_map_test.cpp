// SPDX-License-Identifier: MIT
#include "core/glossy/reflection_map.h"

#include "core/glossy/ggx.h"
#include "core/sh/basis.h"
#include "core/sh/cube_map.h"
#include "core/sh/zonal.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

std::shared_ptr<const ReflectionLevels> levels() {
  static const auto shared = std::make_shared<const ReflectionLevels>(32);
  return shared;
}

std::vector<vec3> mapOf(int side, const auto& f) {
  std::vector<vec3> texels;
  for (const dvec3& d : sh::cubeSamples(side).directions) texels.push_back(f(d));
  return texels;
}

TEST(TexelPyramid, MeansKeepTheIntegral) {
  Rng rng(1);
  const TexelPyramid pyramid(16);
  EXPECT_EQ(pyramid.levels(), 5);
  std::vector<vec3> values(pyramid.size());
  for (std::size_t k = 0; k < 6 * 16 * 16; ++k) values[k] = vec3(rng.uniform());
  pyramid.fill(values);
  const auto integral = [&](int level) {
    const int n = 16 >> level;
    double sum = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(6 * n * n); ++k) {
      const std::size_t at = pyramid.first(level) + k;
      sum += pyramid.solidAngle(at) * static_cast<double>(values[at].x);
      whole += pyramid.solidAngle(at);
    }
    EXPECT_NEAR(whole, 4.0 * kPi, 1e-11);
    return sum;
  };
  for (int level = 1; level < 5; ++level) EXPECT_NEAR(integral(level), integral(0), 1e-5);
}

TEST(SmoothCube, HasNoSeams) {
  // Random texels: at edges and corners the values from both sides are the same.
  Rng rng(6);
  std::vector<vec3> texels(6 * 8 * 8);
  for (vec3& t : texels) t = {rng.uniform(), rng.uniform(), rng.uniform()};
  const SmoothCube cube(8, texels);
  const float tiny = 1e-5F;
  for (int k = 0; k < 500; ++k) {
    vec3 edge(1.0F, 1.0F, 2.0F * rng.uniform() - 1.0F);
    if (k % 10 == 0) edge.z = 1.0F;  // a corner
    const vec3 sign(rng.uniform() < 0.5F ? -1.0F : 1.0F, rng.uniform() < 0.5F ? -1.0F : 1.0F, 1.0F);
    edge = edge * sign;
    for (int turn = 0; turn < 3; ++turn) {
      const vec3 d(edge[turn], edge[(turn + 1) % 3], edge[(turn + 2) % 3]);
      vec3 other = d;
      other[turn] *= 1.0F + tiny;
      vec3 back = d;
      back[turn] *= 1.0F - tiny;
      EXPECT_NEAR(glm::length(cube.at(other) - cube.at(back)), 0.0F, 1e-3F);  // 8 texels a face
    }
  }
}

TEST(SmoothCube, TexelCentresShowTheirTexels) {
  Rng rng(7);
  std::vector<vec3> texels(6 * 4 * 4);
  for (vec3& t : texels) t = vec3(rng.uniform());
  const SmoothCube cube(4, texels);
  const auto directions = sh::cubeSamples(4).directions;
  for (std::size_t k = 0; k < texels.size(); ++k) {
    EXPECT_NEAR(cube.at(vec3(directions[k])).x, texels[k].x, 1e-5F);
  }
}

TEST(ReflectionMap, UniformLightStaysUniform) {
  const ReflectionMap map(levels(), mapOf(32, [](const dvec3&) { return vec3(2.0F, 3.0F, 4.0F); }));
  Rng rng(8);
  for (int k = 0; k < 100; ++k) {
    const vec3 value = map.at(vec3(randomDirection(rng)), rng.uniform());
    EXPECT_NEAR(glm::length(value - vec3(2.0F, 3.0F, 4.0F)), 0.0F, 1e-5F);
  }
}

TEST(ReflectionMap, HarmonicsAreDampedByTheKernel) {
  // Funk-Hecke: a blurred harmonic of degree l is itself times k_l; exact but for texels (bilinear
  // between centres 1/16 apart: l^2 / 2000) and the levels' coarse texels.
  Rng rng(9);
  for (const int l : {1, 2, 4}) {
    const std::size_t index = sh::index(l, 1);
    const auto harmonic = [&](const dvec3& d) {
      std::array<double, 25> basis;
      sh::evaluate(d, 5, basis);
      return basis[index];
    };
    const ReflectionMap map(
        levels(), mapOf(32, [&](const dvec3& d) { return vec3(static_cast<float>(harmonic(d))); }));
    for (const double alpha : {0.08, 0.16, 0.32, 0.64, 1.0}) {
      const double k = sh::ggxReflectedKernel(alpha, 5)[static_cast<std::size_t>(l)];
      for (int trial = 0; trial < 50; ++trial) {
        const dvec3 d = randomDirection(rng);
        EXPECT_NEAR(static_cast<double>(map.at(vec3(d), static_cast<float>(alpha)).x),
                    k * harmonic(d), 0.02)
            << l << ' ' << alpha;
      }
    }
  }
}

TEST(ReflectionMap, PrefilterEqualsTheSumOverAllTexels) {
  // A bright wall and noise, the worst that coarse texels meet.
  Rng rng(10);
  const auto texels =
      mapOf(32, [&](const dvec3& d) { return vec3((d.x > 0.6 ? 5.0F : 0.5F) + rng.uniform()); });
  const TexelPyramid pyramid(32);
  std::vector<vec3> values(pyramid.size());
  std::copy(texels.begin(), texels.end(), values.begin());
  pyramid.fill(values);
  double mean = 0.0, variation = 0.0;
  for (std::size_t k = 0; k < texels.size(); ++k) {
    mean += pyramid.solidAngle(k) * static_cast<double>(texels[k].x) / (4.0 * kPi);
  }
  for (std::size_t k = 0; k < texels.size(); ++k) {
    variation +=
        pyramid.solidAngle(k) / (4.0 * kPi) * std::pow(static_cast<double>(texels[k].x) - mean, 2);
  }
  for (const double alpha : {0.05, 0.2, 0.6}) {
    const PrefilterLevel level(pyramid, 8, alpha);
    std::vector<vec3> out(6 * 8 * 8);
    level.apply(values, out);
    const auto axes = sh::cubeSamples(8).directions;
    double squares = 0.0;
    for (std::size_t a = 0; a < axes.size(); ++a) {
      double sum = 0.0, whole = 0.0;
      for (std::size_t k = 0; k < texels.size(); ++k) {
        const double t = glm::dot(axes[a], pyramid.direction(k));
        const double w =
            pyramid.solidAngle(k) * ggxDensity(std::sqrt(std::max(0.0, 0.5 * (1.0 + t))), alpha);
        sum += w * static_cast<double>(texels[k].x);
        whole += w;
      }
      squares += std::pow(static_cast<double>(out[a].x) - sum / whole, 2);
    }
    const double error = std::sqrt(squares / static_cast<double>(axes.size()) / variation);
    EXPECT_LT(error, 0.01) << alpha << ", taps per texel "
                           << static_cast<double>(level.taps()) / (6 * 8 * 8);
  }
}

TEST(ReflectionMap, LevelsAreMetContinuously) {
  Rng rng(11);
  std::vector<vec3> texels(6 * 32 * 32);
  for (vec3& t : texels) t = vec3(rng.uniform());
  const ReflectionMap map(levels(), texels);
  const vec3 d = glm::normalize(vec3(0.3F, 0.8F, -0.4F));
  float before = map.at(d, 1e-4F).x;
  for (float alpha = 1e-4F; alpha < 1.2F; alpha *= 1.01F) {
    const float now = map.at(d, alpha).x;
    EXPECT_NEAR(now, before, 0.05F);  // a step of 1 % in alpha is 1/35 of the way between levels
    before = now;
  }
}

}  // namespace
}  // namespace soffit::glossy
