// SPDX-License-Identifier: MIT
#include "core/glossy/visibility.h"

#include "core/sh/cube_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace soffit::glossy {
namespace {

/// A large upright wall in the plane x = 1, from far below to far above.
geometry::RayCaster wall() {
  const std::array<vec3, 4> corners{vec3(1, -1e4F, -1e4F), vec3(1, 1e4F, -1e4F),
                                    vec3(1, 1e4F, 1e4F), vec3(1, -1e4F, 1e4F)};
  const std::array<uvec3, 2> triangles{uvec3(0, 1, 2), uvec3(0, 2, 3)};
  return {corners, triangles};
}

TEST(Visibility, OpenGroundSeesTheUpperHalf) {
  const geometry::RayCaster nothing({}, {});
  const sh::SphereSamples samples = sh::cubeSamples(64);
  const std::array<vec3, 1> at{vec3(0.0F)};
  const std::array<vec3, 1> up{vec3(0.0F, 0.0F, 1.0F)};
  const VisibilityBits bits = lookAround(nothing, at, up, samples);
  const sh::Coefficients v = visibilityCoefficients(bits, 0, samples, 3);
  // Half of v_00 = 2 sqrt(pi); v_10 = 2 pi sqrt(3 / 4 pi) / 2. The equator runs between texels;
  // what is left is the midpoint rule of a texel, (1 / 64)^2.
  EXPECT_NEAR(v[0], std::sqrt(kPi), 1e-12);
  EXPECT_NEAR(v[sh::index(1, 0)], std::sqrt(3.0 * kPi) / 2.0, 5e-4);
  EXPECT_NEAR(v[sh::index(1, 1)], 0.0, 1e-9);
  EXPECT_NEAR(v[sh::index(2, 0)], 0.0, 5e-4);
}

TEST(Visibility, AWallHidesWhatIsBehindIt) {
  const sh::SphereSamples samples = sh::cubeSamples(16);
  const std::array<vec3, 2> at{vec3(0.0F), vec3(3.0F, 0.0F, 0.0F)};
  const std::array<vec3, 2> up{vec3(0, 0, 1), vec3(0, 0, 1)};
  const VisibilityBits bits = lookAround(wall(), at, up, samples);
  const VisibilityBits near = lookAround(wall(), at, up, samples, 0.5F);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const dvec3& d = samples.directions[k];
    EXPECT_EQ(bits.open(0, k), d.z > 0.0 && d.x < 0.0);
    EXPECT_EQ(bits.open(1, k), d.z > 0.0 && d.x > 0.0);
    EXPECT_EQ(near.open(0, k), d.z > 0.0);  // nothing within half a metre
  }
  EXPECT_EQ(bits.bytes(), 2U * (16U * 16U * 6U / 8U));
}

}  // namespace
}  // namespace soffit::glossy
