// SPDX-License-Identifier: MIT
#include "core/glossy/bounces.h"

#include "core/sh/cube_map.h"
#include "core/sh/index.h"
#include "tests/core/glossy/test_box.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

constexpr float kRho = 0.6F;

/// A receiver in the middle of each wall of a cube; every ray meets the wall whose receiver stands
/// for it.
struct ClosedCube {
  geometry::RayCaster caster = boxCaster({-1, -1, -1}, {1, 1, 1});
  std::vector<vec3> positions, normals;
  std::vector<std::uint32_t> source_of;
  std::vector<vec3> reflectance;
  std::shared_ptr<const sh::SphereSamples> samples =
      std::make_shared<const sh::SphereSamples>(sh::cubeSamples(24));
  std::unique_ptr<FirstHits> first;

  ClosedCube() {
    for (int wall = 0; wall < 6; ++wall) {
      vec3 p(0.0F);
      p[wall / 2] = wall % 2 == 0 ? -1.0F : 1.0F;
      positions.push_back(p);
      normals.push_back(-p);
      reflectance.emplace_back(kRho, kRho, 0.5F * kRho);
    }
    first = std::make_unique<FirstHits>(caster, positions, normals, samples);
    for (std::size_t r = 0; r < 6; ++r) {
      for (const geometry::Hit& hit : first->hits(r)) {
        source_of.push_back(hit.valid() ? hit.triangle / 2 : kNoSource);
      }
    }
  }
};

TEST(Bounces, FurnaceGivesPowersOfTheReflectance) {
  // Direct light of 1 lx everywhere: after b reflections rho^b lx arrives from everywhere above.
  const ClosedCube cube;
  const std::vector<vec3> direct(6, vec3(1.0F));
  const auto textures =
      bounceTextures({*cube.first, cube.normals, cube.source_of, cube.reflectance}, direct, 3, 3);
  ASSERT_EQ(textures.size(), 3U);
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double rho = c == 2 ? 0.3 : 0.6;
        const double radiance = std::pow(rho, static_cast<double>(b) + 1.0) / kPi;
        // Half of v_00 = 2 sqrt(pi); the cosine over texels of 24 a side: (1 / 24)^2 a bounce.
        EXPECT_NEAR(static_cast<double>(textures[b].at(r, c * 9)), radiance * std::sqrt(kPi),
                    radiance * 0.004);
      }
    }
  }
}

TEST(Bounces, GatherEqualsTheCallback) {
  const ClosedCube cube;
  std::vector<vec3> radiance;
  for (int wall = 0; wall < 6; ++wall) {
    radiance.emplace_back(static_cast<float>(wall), 1.0F, 0.5F * static_cast<float>(wall * wall));
  }
  const FloatBlocks gathered = arrivingLight(*cube.first, cube.source_of, radiance, 4);
  const FloatBlocks asked = arrivingLight(
      *cube.first,
      [&](std::span<const geometry::Ray>, std::span<const geometry::Hit> hits,
          std::span<vec3> out) {
        for (std::size_t k = 0; k < hits.size(); ++k) out[k] = radiance[hits[k].triangle / 2];
      },
      4);
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t k = 0; k < 48; ++k) EXPECT_FLOAT_EQ(gathered.at(r, k), asked.at(r, k));
  }
}

TEST(Bounces, ArrivingLightPointsToTheBrightWall) {
  const ClosedCube cube;
  std::vector<vec3> radiance(6, vec3(0.0F));
  radiance[5] = vec3(1.0F);  // the ceiling
  const FloatBlocks arriving = arrivingLight(*cube.first, cube.source_of, radiance, 2);
  // The floor (4) sees it straight above: sum of w y_10 over the square of +-1 at height 2.
  const double solid_angle = sh::rectangleSolidAngle(-0.5, -0.5, 0.5, 0.5);
  EXPECT_NEAR(static_cast<double>(arriving.at(4, 0)), solid_angle * std::sqrt(0.25 / kPi), 0.01);
  EXPECT_NEAR(arriving.at(4, sh::index(1, 1)), 0.0F, 1e-5F);
  EXPECT_GT(arriving.at(4, sh::index(1, 0)), 0.2F);
  EXPECT_GT(arriving.at(0, sh::index(1, 0)), 0.1F);  // a wall sees it above
  EXPECT_EQ(arriving.at(5, 0), 0.0F);                // itself not at all
}

}  // namespace
}  // namespace soffit::glossy
