// SPDX-License-Identifier: MIT
#include "core/glossy/ggx.h"

#include "core/math/quadrature.h"
#include "core/math/rng.h"
#include "core/render/microfacet.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

TEST(Ggx, DensityIsNormalisedByProjectedArea) {
  for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
    // 2 pi integral D mu dmu with mu^2 = x, x = 1 - w / (1 + ...): by the distribution's inverse
    // every share u of it has the same weight, so that the sum is that of the map's Jacobian.
    const QuadratureRule rule = gaussLegendre(64, 0.0, 1.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double u = rule.nodes[i];
      const double a2 = alpha * alpha;
      const double mu2 = (1.0 - u) / (1.0 - u + a2 * u);
      const double slope = a2 / ((1.0 - u + a2 * u) * (1.0 - u + a2 * u));  // -d mu2 / du
      sum += rule.weights[i] * kPi * ggxDensity(std::sqrt(mu2), alpha) * slope;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);  // round-off
  }
}

TEST(Ggx, LobeEqualsThePicturesLobe) {
  Rng rng(5);
  for (int k = 0; k < 1000; ++k) {
    const dvec3 wo = upperDirection(rng);
    const dvec3 wi = upperDirection(rng);
    const double alpha = 0.02 + 0.98 * rng.uniformDouble();
    const double f0 = rng.uniformDouble();
    const double cos_h = glm::dot(wo, glm::normalize(wo + wi));
    const double lobe = ggxLobe(wo, wi, alpha) * (f0 + (1.0 - f0) * schlickRise(cos_h));
    const auto picture = static_cast<double>(render::ggxReflection(
        vec3(wo), vec3(wi), static_cast<float>(f0), static_cast<float>(alpha)));
    // Single precision; D of a sharp lobe magnifies the error of the half vector by 1 / alpha^2.
    EXPECT_NEAR(lobe, picture, (1e-5 + 1e-6 / (alpha * alpha)) * lobe + 1e-7);
  }
}

TEST(Ggx, DrawsIntegrateTheLobe) {
  // The mean of weight f(wi) over the square against the lobe times f by a product rule.
  const auto f = [](const dvec3& w) { return 1.0 + 0.5 * w.x + w.y * w.y - 0.3 * w.z; };
  for (const double alpha : {0.3, 0.7}) {
    const dvec3 wo = glm::normalize(dvec3(0.6, 0.2, 0.7));
    constexpr int kSide = 400;
    double drawn = 0.0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const GgxDraw d = drawGgx(wo, alpha, {(i + 0.5) / kSide, (j + 0.5) / kSide});
        drawn += d.weight * f(d.wi) / (kSide * kSide);
      }
    }
    const QuadratureRule heights = gaussLegendre(200, 0.0, 1.0);
    constexpr int kAzimuths = 400;
    double summed = 0.0;
    for (std::size_t i = 0; i < heights.nodes.size(); ++i) {
      for (int j = 0; j < kAzimuths; ++j) {
        const double z = heights.nodes[i];
        const double phi = 2.0 * kPi * j / kAzimuths;
        const double s = std::sqrt(1.0 - z * z);
        const dvec3 wi(s * std::cos(phi), s * std::sin(phi), z);
        summed += heights.weights[i] * 2.0 * kPi / kAzimuths * ggxLobe(wo, wi, alpha) * f(wi);
      }
    }
    EXPECT_NEAR(drawn, summed, 1e-4 * summed);  // the map has a crease where wi leaves the surface
  }
}

TEST(Ggx, NothingGoesBelowTheSurface) {
  EXPECT_EQ(ggxLobe({0, 0, 1}, {0, 0, -1}, 0.5), 0.0);
  EXPECT_EQ(ggxLobe({0, 0, -1}, {0, 0, 1}, 0.5), 0.0);
  EXPECT_EQ(drawGgx(glm::normalize(dvec3(1, 0, 0.01)), 1.0, {0.9999, 0.75}).weight, 0.0);
}

}  // namespace
}  // namespace soffit::glossy
