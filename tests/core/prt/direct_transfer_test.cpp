// SPDX-License-Identifier: MIT
#include "core/prt/direct_transfer.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/sh/analytic_light.h"
#include "core/sh/convolution.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::evenLight;
using testing::illuminance;
using testing::matte;
using testing::pointReceivers;
using testing::shadowed;

/// Sums of single precision over up to some thousand directions.
constexpr double kRoundoff = 1e-5;

TEST(DirectTransfer, UnshadowedIsTheCosineLobeInClosedForm) {
  const sh::Coefficients light = sh::analyticCoefficients({}, 5);
  Rng rng(3);
  for (int k = 0; k < 50; ++k) {
    const vec3 n = uniformSphere(rng.uniform(), rng.uniform());
    const auto rows = unshadowedTransfer(pointReceivers({vec3(0)}, n), 5);
    EXPECT_NEAR(illuminance(rows, 0, light), sh::irradiance(light, glm::normalize(dvec3(n))),
                kRoundoff);
  }
}

TEST(DirectTransfer, OpenReceiversEqualTheClosedFormWhateverTheSamples) {
  const auto empty = Builder().surfaces();
  Rng rng(4);
  for (const auto& samples :
       {sh::randomSamples(300, 1), sh::stratifiedSamples(16, 2), sh::hammersleySamples(64)}) {
    const Directions directions(samples, 4);
    for (int k = 0; k < 10; ++k) {
      const Receivers r = pointReceivers({vec3(0)}, uniformSphere(rng.uniform(), rng.uniform()));
      const auto exact = unshadowedTransfer(r, 4);
      const auto found = shadowed(*empty, r, directions);
      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(found.vector(0)[i], exact.vector(0)[i], kRoundoff);
      }
    }
  }
}

TEST(DirectTransfer, AClosedRoomLetsNothingIn) {
  const auto surfaces = Builder()
                            .add(geometry::makeBox({0, 0, 0}, {4, 3, 2}), matte(vec3(0.5F)))
                            .surfaces({vec3(1, 1, 1)});
  const VertexReceivers set(surfaces);
  const auto rows = shadowed(*surfaces, set.receivers(), {sh::stratifiedSamples(20, 1), 5});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const float t : rows.vector(i)) EXPECT_EQ(t, 0.0F);
  }
}

TEST(DirectTransfer, ADiskOverheadTakesItsProjectedShare) {
  // a^2 / (a^2 + h^2) of even light, on its axis; an inscribed fan of 256 is 1e-4 smaller.
  const auto disk = testing::moved(geometry::makeDisk(0.8F, 256), {0, 0, 1});
  const auto surfaces = Builder().add(disk, matte(vec3(0.5F))).surfaces();
  const Receivers at = pointReceivers({{0, 0, 0}}, {0, 0, 1});
  const double wanted = kPi * (1.0 - 0.64 / 1.64);
  // The circle's outline of 2 pi 0.78 in a disk of N/2 cells errs by chance in the cells it cuts:
  // perimeter x sqrt(cells) of them, each by at most half: below 3 sigma of that.
  for (const int n : {1000, 10000}) {
    const auto rows = shadowed(*surfaces, at, {sh::hammersleySamples(n), 3});
    const double sigma = 0.5 * std::sqrt(4.9 * std::sqrt(0.5 * n)) / (0.5 * n);
    EXPECT_NEAR(illuminance(rows, 0, evenLight(3)), wanted, 3.0 * kPi * sigma + 1e-3) << n;
  }
}

TEST(DirectTransfer, ALongWallHalvesEvenLight) {
  Builder b;
  b.add(testing::quad({0.001F, -1e4F, 0}, {0, 2e4F, 0}, {0, 0, 1e4F}), matte(vec3(0.5F)));
  const auto surfaces = b.surfaces();
  const Receivers at = pointReceivers({{0, 0, 0}}, {0, 0, 1});
  const auto rows = shadowed(*surfaces, at, {sh::stratifiedSamples(64, 3), 3});
  // The half sphere's border cuts some 2 x 64 of 4096 cells, each by chance: sigma 0.5 sqrt(128) /
  // 2048 of the hemisphere.
  EXPECT_NEAR(illuminance(rows, 0, evenLight(3)), kPi / 2, 4 * kPi * 0.5 * std::sqrt(128.0) / 2048);
}

/// E of one point under `light` by brute force: the rays, but no harmonics.
double bruteForce(const Surfaces& s, const vec3& p, const vec3& n, const sh::Coefficients& light) {
  const sh::SphereSamples samples = sh::hammersleySamples(200000);
  double sum = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const vec3 d(samples.directions[k]);
    const float cosine = glm::dot(d, n);
    if (cosine <= 0.0F) continue;
    if (s.caster->occluded({geometry::offsetOrigin(p, n), 0.0F, d})) continue;
    sum += samples.weights[k] * double{cosine} * sh::reconstruct(light, samples.directions[k]);
  }
  return sum;
}

TEST(DirectTransfer, ShadowsOfLowLightAreThoseOfBruteForce) {
  // Light of 4 bands needs 4 bands of transfer and no more, whatever the shadow's shape.
  const auto surfaces = testing::blockOnFloor(2, vec3(0.5F), vec3(0.5F)).surfaces();
  const Receivers at =
      pointReceivers({{0.8F, 0.2F, 0}, {-0.7F, -0.9F, 0}, {1.8F, 0, 0}}, {0, 0, 1});
  const sh::Coefficients light = sh::analyticCoefficients({}, 4);
  const auto rows = shadowed(*surfaces, at, {sh::hammersleySamples(4096), 4});
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double wanted = bruteForce(*surfaces, at.positions[i], at.normals[i], light);
    EXPECT_NEAR(illuminance(rows, i, light), wanted, 0.01 * wanted) << i;
  }
}

TEST(DirectTransfer, EvenSamplesConvergeFasterThanRandomOnes) {
  const auto surfaces = testing::blockOnFloor(10, vec3(0.5F), vec3(0.5F)).surfaces();
  const Receivers r = VertexReceivers(surfaces).receivers();

  const sh::Coefficients light = sh::analyticCoefficients({}, 5);
  const auto exact = shadowed(*surfaces, r, {sh::hammersleySamples(60000), 5});
  const auto error = [&](const sh::SphereSamples& samples) {
    const auto rows = shadowed(*surfaces, r, {samples, 5});
    double sum = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      sum += std::pow(illuminance(rows, i, light) - illuminance(exact, i, light), 2);
    }
    return std::sqrt(sum / static_cast<double>(r.size()));
  };
  const auto meanError = [&](auto make) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) sum += std::pow(error(make(seed)), 2);
    return std::sqrt(sum / 4);
  };
  const double random = meanError([](std::uint64_t s) { return sh::randomSamples(1024, s); });
  const double jitter = meanError([](std::uint64_t s) { return sh::stratifiedSamples(32, s); });
  const double hammersley = error(sh::hammersleySamples(1024));
  EXPECT_LT(jitter, 0.6 * random);
  EXPECT_LT(hammersley, jitter);
  // Shadows have edges: four times the samples take the error down to about 4^(-3/4) = 0.35 with
  // jitter, to a half with random ones.
  const auto finer = [](std::uint64_t s) { return sh::stratifiedSamples(64, s); };
  EXPECT_LT(meanError(finer), 0.45 * jitter);
}

TEST(DirectTransfer, NewNormalsNeedNoRays) {
  const auto surfaces = testing::blockOnFloor(4, vec3(0.5F), vec3(0.5F)).surfaces();
  Receivers at = pointReceivers({{0.8F, 0.2F, 0}}, {0, 0, 1});
  const Directions directions(sh::hammersleySamples(4096), 4);
  const auto pass = traceShadows(*surfaces, at, directions).value();
  at.normals[0] = glm::normalize(vec3(0.4F, 0.1F, 1));
  const auto rows = shadowedTransfer(at, directions, pass.flags).value();
  // Directions below the real surface stay dark though the bent normal sees them.
  const sh::SphereSamples fine = sh::hammersleySamples(200000);
  double wanted = 0.0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const vec3 d(fine.directions[k]);
    if (d.z <= 0.0F || glm::dot(d, at.normals[0]) <= 0.0F) continue;
    if (surfaces->caster->occluded({{0.8F, 0.2F, 1e-5F}, 0.0F, d})) continue;
    wanted += fine.weights[k] * double{glm::dot(d, at.normals[0])};
  }
  EXPECT_NEAR(illuminance(rows, 0, evenLight(4)), wanted, 0.01 * wanted);
}

TEST(DirectTransfer, RowsThatStandForAnotherAreCopies) {
  const auto surfaces = testing::blockOnFloor(4, vec3(0.5F), vec3(0.5F)).surfaces();
  Receivers at = pointReceivers({{0.8F, 0.2F, 0}, {0, 0, 0.5F}}, {0, 0, 1});
  at.source = {0, 0};
  const auto rows = shadowed(*surfaces, at, {sh::hammersleySamples(256), 3});
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(rows.vector(0)[i], rows.vector(1)[i]);
}

}  // namespace
}  // namespace soffit::prt
