// SPDX-License-Identifier: MIT
#include "core/reference/bsdf.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

const dvec3 kNormal = glm::normalize(dvec3(1, -2, 3));

Bsdf glossy(double diffuse, double specular, double alpha) {
  return {.normal = kNormal, .diffuse = dvec3(diffuse), .specular = specular, .alpha = alpha};
}

dvec3 directionAt(double cosine, double phi) {
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(kNormal, t, b);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return sine * std::cos(phi) * t + sine * std::sin(phi) * b + cosine * kNormal;
}

dvec3 random3(Rng& rng) {
  const double x = rng.uniformDouble();
  const double y = rng.uniformDouble();
  return {x, y, rng.uniformDouble()};
}

struct Mean {
  double value = 0.0;
  double error = 0.0;
};

template <class F>
Mean meanOf(int count, const F& f) {
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = f();
    sum += x;
    squares += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

constexpr double kSigmas = 4.5;
constexpr int kCount = 200000;

TEST(Bsdf, LambertianReflectsExactlyItsAlbedo) {
  const Bsdf b = glossy(0.7, 0.0, 0.25);
  const dvec3 wo = directionAt(0.4, 1.0);
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(sample(b, wo, random3(rng)).weight.y, 0.7, 1e-14);  // importance is perfect
  }
  EXPECT_NEAR(evaluate(b, wo, directionAt(0.2, 3.0)).x, 0.7 / kPi, 1e-15);
}

TEST(Bsdf, MirrorReflectsTheSchlickTermInTheMirrorDirection) {
  const Bsdf b = glossy(0.0, 0.04, 0.0);
  const dvec3 wo = directionAt(0.5, 1.0);
  const BsdfSample s = sample(b, wo, {0.3, 0.4, 0.5});
  EXPECT_NEAR(glm::length(s.direction - directionAt(0.5, 1.0 + kPi)), 0.0, 1e-14);
  EXPECT_NEAR(s.weight.x, 0.04 + 0.96 / 32.0, 1e-14);
  EXPECT_EQ(s.density, 0.0);
  EXPECT_EQ(evaluate(b, wo, s.direction), dvec3(0.0));
}

TEST(Bsdf, IsReciprocal) {
  for (const double alpha : {0.01, 0.2, 1.0}) {
    const Bsdf b = glossy(0.3, 0.5, alpha);
    const dvec3 v = directionAt(0.3, 0.2);
    const dvec3 w = directionAt(0.35, 3.3);
    EXPECT_NEAR(evaluate(b, v, w).x / evaluate(b, w, v).x, 1.0, 1e-12) << alpha;
  }
}

TEST(Bsdf, ReflectsNothingBelowTheSurface) {
  const Bsdf b = glossy(0.3, 0.5, 0.2);
  EXPECT_EQ(evaluate(b, directionAt(0.5, 0.0), directionAt(-0.1, 2.0)), dvec3(0.0));
  EXPECT_EQ(density(b, directionAt(0.5, 0.0), directionAt(-0.1, 2.0)), 0.0);
}

class GlossyBsdf : public testing::TestWithParam<std::pair<double, double>> {};

/// Samples land where density() says: what is missing from 1 fell below the surface.
TEST_P(GlossyBsdf, DensityIntegratesToTheShareOfSamplesAboveTheSurface) {
  const auto [alpha, cosine] = GetParam();
  const Bsdf b = glossy(0.2, 0.3, alpha);
  const dvec3 wo = directionAt(cosine, 1.0);
  Rng rng(2);
  const Mean above =
      meanOf(kCount, [&] { return sample(b, wo, random3(rng)).density > 0.0 ? 1.0 : 0.0; });
  // The same integral by uniform directions, on a rotated grid about the normal: the lobe is wide
  // enough for that from alpha 0.2.
  const Mean integral = meanOf(kCount, [&] {
    const dvec3 u = random3(rng);
    return density(b, wo, directionAt(u.x, 2.0 * kPi * u.y)) * 2.0 * kPi;
  });
  EXPECT_NEAR(above.value, integral.value, kSigmas * (above.error + integral.error));
}

TEST_P(GlossyBsdf, SamplingAndEvaluatingGiveTheSameAlbedo) {
  const auto [alpha, cosine] = GetParam();
  const Bsdf b = glossy(0.2, 0.3, alpha);
  const dvec3 wo = directionAt(cosine, 1.0);
  Rng rng(3);
  const Mean sampled = meanOf(kCount, [&] { return sample(b, wo, random3(rng)).weight.x; });
  const Mean integral = meanOf(kCount, [&] {
    const dvec3 u = random3(rng);
    return evaluate(b, wo, directionAt(u.x, 2.0 * kPi * u.y)).x * u.x * 2.0 * kPi;
  });
  EXPECT_NEAR(sampled.value, integral.value, kSigmas * (sampled.error + integral.error));
}

INSTANTIATE_TEST_SUITE_P(Lobes, GlossyBsdf,
                         testing::Values(std::pair{0.2, 0.95}, std::pair{0.2, 0.3},
                                         std::pair{0.5, 0.7}, std::pair{1.0, 0.1}));

TEST(Bsdf, WhiteFurnaceNeverGainsAndRoughnessLosesMore) {
  // Reflectance 1 everywhere: what masking takes away is not scattered again (single scattering).
  const dvec3 wo = directionAt(0.6, 1.0);
  double previous = 1.0;
  for (const double alpha : {0.02, 0.3, 1.0}) {
    const Bsdf b = glossy(0.0, 1.0, alpha);
    Rng rng(4);
    double most = 0.0;
    const Mean reflected = meanOf(kCount, [&] {
      const double weight = sample(b, wo, random3(rng)).weight.x;
      most = std::max(most, weight);
      return weight;
    });
    EXPECT_LE(most, 1.0 + 1e-9) << alpha;  // round-off; every weight is G2 / G1
    EXPECT_LT(reflected.value, previous) << alpha;
    previous = reflected.value;
    if (alpha < 0.1) {
      EXPECT_GT(reflected.value, 0.995);
    }
  }
}

TEST(Bsdf, NarrowLobesApproachTheMirror) {
  const dvec3 wo = directionAt(0.5, 1.0);
  Rng rng(5);
  const Bsdf narrow = glossy(0.0, 0.5, 1e-4);
  for (int i = 0; i < 100; ++i) {
    const BsdfSample s = sample(narrow, wo, random3(rng));
    if (!(s.density > 0.0)) continue;
    // Lobes have tails, but the weight is the mirror's wherever the direction is near.
    if (glm::dot(s.direction, directionAt(0.5, 1.0 + kPi)) < 0.99999) continue;
    EXPECT_NEAR(s.weight.x, 0.5 + 0.5 / 32.0, 2e-3);
  }
}

}  // namespace
}  // namespace soffit::reference
