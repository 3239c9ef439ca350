// SPDX-License-Identifier: MIT
#include "core/sh/convolution.h"

#include "core/sh/basis.h"
#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

namespace soffit::sh {
namespace {

TEST(Irradiance, OfAUniformSkyIsPiTimesItsLuminance) {
  const Coefficients sky{100.0 * 2.0 * std::sqrt(kPi), 0, 0, 0, 0, 0, 0, 0, 0};
  for (const dvec3& n : testDirections(20, 51))
    EXPECT_NEAR(irradiance(sky, n), 100.0 * kPi, 1e-12 * 314);
}

// L = a + b (d . e): E(n) = pi a + (2 pi / 3) b (n . e), exact in two bands.
TEST(Irradiance, OfALinearSkyIsExact) {
  Rng rng(52);
  const dvec3 e = randomDirection(rng);
  const auto sky = [&](const dvec3& d) { return 5.0 + 3.0 * glm::dot(d, e); };
  const Coefficients c = project(sky, cubature(6), 4);
  for (const dvec3& n : testDirections(50, 53)) {
    EXPECT_NEAR(irradiance(c, n), 5.0 * kPi + 2.0 * kPi * glm::dot(n, e), 1000 * kEps);
  }
}

// Convolution with the clamped cosine against the integral itself, for light of degree 9.
TEST(Convolve, ClampedCosineEqualsTheIntegralOverTheHemisphere) {
  Rng rng(54);
  const Coefficients light = randomCoefficients(kMaxBands, rng);
  const Coefficients e = convolve(light, clampedCosineKernel(kMaxBands));
  for (int i = 0; i < 6; ++i) {
    // The hemisphere by a rule about n: polynomial in t on [0, 1], trigonometric around.
    const dvec3 n = randomDirection(rng);
    const dvec3 side = glm::normalize(glm::cross(n, dvec3(0.31, 0.87, 0.12)));
    const dvec3 up = glm::cross(n, side);
    double sum = 0.0;
    const SphereSamples rule = cubature(23);
    for (std::size_t k = 0; k < rule.size(); ++k) {
      // z in [-1, 1] moved to t in [0, 1]; the azimuth stays.
      const dvec3& d = rule.directions[k];
      const double t = 0.5 * (d.z + 1.0);
      const double r = std::sqrt((1.0 - t) * (1.0 + t)) / std::sqrt((1.0 - d.z) * (1.0 + d.z));
      const dvec3 s = t * n + r * (d.x * side + d.y * up);
      sum += 0.5 * rule.weights[k] * t * reconstruct(light, s);
    }
    EXPECT_NEAR(reconstruct(e, n), sum, 1e4 * kEps);
  }
}

TEST(Convolve, NormalisedLobesKeepTheMean) {
  Rng rng(55);
  const Coefficients light = randomCoefficients(5, rng);
  for (const Kernel& kernel :
       {phongKernel(20.0, 5), vonMisesFisherKernel(7.0, 5), ggxReflectedKernel(0.3, 5)}) {
    EXPECT_NEAR(convolve(light, kernel)[0], light[0], 64 * kEps);
  }
}

}  // namespace
}  // namespace soffit::sh
