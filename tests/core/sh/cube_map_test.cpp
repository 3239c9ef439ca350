// SPDX-License-Identifier: MIT
#include "core/sh/cube_map.h"

#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <numeric>

namespace soffit::sh {
namespace {

TEST(CubeMap, FacesAreRightHandedFramesOfTheSixAxes) {
  dvec3 sum(0.0);
  for (const CubeFace& face : kCubeFaces) {
    EXPECT_EQ(glm::cross(face.right, face.up), -face.forward);
    EXPECT_EQ(glm::dot(face.right, face.up), 0.0);
    sum += face.forward;
    EXPECT_EQ(glm::length(face.forward), 1.0);
  }
  EXPECT_EQ(sum, dvec3(0.0));
  for (std::size_t side = 0; side < 4; ++side) EXPECT_EQ(kCubeFaces[side].up, dvec3(0, 0, 1));
}

TEST(CubeMap, SidesRunOnAroundTheRoomAndTopAndBottomFitToPlusY) {
  // The right edge of each side is the left edge of the next, clockwise seen from above.
  const std::array<int, 4> around{2, 0, 3, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double v : {-0.7, 0.0, 0.4}) {
      const dvec3 right = cubeDirection({around[i], 1.0, v});
      const dvec3 left = cubeDirection({around[(i + 1) % 4], -1.0, v});
      EXPECT_LE(glm::length(right - left), 4 * kEps);
    }
  }
  for (const double u : {-0.8, 0.1, 1.0}) {
    EXPECT_LE(glm::length(cubeDirection({4, u, 1.0}) - cubeDirection({2, u, -1.0})), 4 * kEps);
    EXPECT_LE(glm::length(cubeDirection({5, u, -1.0}) - cubeDirection({2, u, 1.0})), 4 * kEps);
  }
}

TEST(CubeMap, FacesCover90Degrees) {
  const double edge = glm::dot(cubeDirection({0, -1.0, 0.0}), cubeDirection({0, 1.0, 0.0}));
  EXPECT_NEAR(edge, 0.0, 2 * kEps);
}

TEST(CubeMap, PlacesAndDirectionsAreInverse) {
  for (const dvec3& d : testDirections(2000, 21)) {
    const CubePoint p = cubePoint(3.7 * d);
    EXPECT_LE(std::abs(p.u), 1.0);
    EXPECT_LE(std::abs(p.v), 1.0);
    EXPECT_LE(glm::length(cubeDirection(p) - d), 8 * kEps);
  }
}

TEST(CubeMap, TexelsAreInMemoryOrder) {
  for (const int n : {1, 2, 5, 16}) {
    const SphereSamples samples = cubeSamples(n);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(6 * n * n));
    for (std::size_t k = 0; k < samples.size(); ++k) {
      EXPECT_EQ(texelOf(samples.directions[k], n), k);
    }
  }
}

TEST(CubeMap, SolidAnglesSumToTheSphere) {
  for (const int n : {1, 2, 3, 16, 64, 128}) {
    const SphereSamples samples = cubeSamples(n);
    const double sum = std::accumulate(samples.weights.begin(), samples.weights.end(), 0.0);
    EXPECT_NEAR(sum, 4.0 * kPi, 4.0 * kPi * 6 * n * kEps) << n;
    for (const double w : samples.weights) EXPECT_GT(w, 0.0);
  }
}

TEST(CubeMap, SolidAnglesAreThoseOfTheMidpointRuleForSmallTexels) {
  constexpr int kSide = 64;
  const SphereSamples samples = cubeSamples(kSide);
  double fujita = 0.0, midpoint = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const CubePoint p = cubePoint(samples.directions[k]);
    const double r2 = 1.0 + p.u * p.u + p.v * p.v;
    const double angle = 4.0 / (kSide * kSide) * std::pow(r2, -1.5);
    EXPECT_NEAR(angle / samples.weights[k], 1.0, 3e-4);  // numerics.md 1.3: 2.4e-4 at 64
    midpoint += angle;
    fujita += 4.0 * kPi / double(samples.size()) / std::sqrt(r2);
  }
  EXPECT_NEAR(midpoint, 4.0 * kPi, 4.0 * kPi * 1e-4);
  EXPECT_NEAR(1.0 - fujita / (4.0 * kPi), 0.207, 0.001);  // what the paper's weights lose
}

TEST(CubeMap, ProjectsSmoothLightWithTheErrorOfItsTexels) {
  const auto f = [](const dvec3& d) { return std::exp(2.0 * d.z + d.x); };
  const Coefficients exact = project(f, cubature(60), 5);
  const double coarse = largestDifference(project(f, cubeSamples(16), 5), exact);
  const double fine = largestDifference(project(f, cubeSamples(32), 5), exact);
  EXPECT_LT(fine, 0.3 * coarse);  // second order: a quarter
  EXPECT_LT(fine, 2e-3 * exact[0]);
}

}  // namespace
}  // namespace soffit::sh
