// SPDX-License-Identifier: MIT
#include "core/sh/rotation.h"

#include "core/sh/basis.h"
#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

namespace soffit::sh {
namespace {

/// Random turns, none at all, half turns, quarter turns and turns by next to nothing.
std::vector<dmat3> turns() {
  Rng rng(61);
  std::vector<dmat3> all{dmat3(1.0)};
  for (int i = 0; i < 10; ++i) {
    all.push_back(turnAbout(randomDirection(rng), 2.0 * kPi * rng.uniformDouble()));
  }
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 a(0.0);
    a[axis] = 1.0;
    for (const double angle : {kPi, kPi / 2.0, -kPi / 2.0, 1e-9, kPi - 1e-9}) {
      all.push_back(turnAbout(a, angle));
    }
  }
  return all;
}

TEST(Rotation, MovesTheBasisAsTheDirections) {
  std::array<double, kMaxCoefficients> here, there;
  for (const dmat3& matrix : turns()) {
    const Rotation rotation(matrix, kMaxBands);
    for (const dvec3& d : testDirections(10, 62)) {
      evaluate(d, kMaxBands, here);
      evaluate(glm::normalize(matrix * d), kMaxBands, there);
      EXPECT_LE(largestDifference(rotation.apply(here), there), 1e-13);
    }
  }
}

TEST(Rotation, IsOrthogonal) {
  for (const dmat3& matrix : turns()) {
    const Rotation rotation(matrix, kMaxBands);
    for (int l = 0; l < kMaxBands; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (int n = -l; n <= l; ++n) {
          double sum = 0.0;
          for (int k = -l; k <= l; ++k)
            sum += rotation.element(l, m, k) * rotation.element(l, n, k);
          EXPECT_NEAR(sum, m == n ? 1.0 : 0.0, 1e-13);
        }
      }
    }
  }
}

TEST(Rotation, EqualsProjectingTheTurnedFunction) {
  const auto f = [](const dvec3& d) { return std::exp(1.5 * d.x - d.z) + d.y * d.y * d.x; };
  const SphereSamples rule = cubature(50);
  for (const int bands : {1, 3, 5, 10}) {
    const Coefficients c = project(f, rule, bands);
    for (const dmat3& matrix : turns()) {
      const auto turned = [&](const dvec3& d) { return f(glm::transpose(matrix) * d); };
      // product.md asks for 1e-4; f is analytic, so only rounding is left.
      EXPECT_LE(largestDifference(Rotation(matrix, bands).apply(c), project(turned, rule, bands)),
                1e-11);
    }
  }
}

TEST(Rotation, ComposesAndInverts) {
  Rng rng(63);
  const Coefficients c = randomCoefficients(kMaxBands, rng);
  const std::vector<dmat3> all = turns();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const Rotation a(all[i], kMaxBands), b(all[i + 1], kMaxBands);
    const Rotation both(all[i + 1] * all[i], kMaxBands);
    EXPECT_LE(largestDifference(b.apply(a.apply(c)), both.apply(c)), 1e-12);
    EXPECT_LE(largestDifference(a.applyInverse(a.apply(c)), c), 1e-12);
    const Rotation back(glm::transpose(all[i]), kMaxBands);
    EXPECT_LE(largestDifference(a.applyInverse(c), back.apply(c)), 1e-12);
  }
}

TEST(Rotation, KeepsTheEnergyOfEachBand) {
  Rng rng(64);
  const Coefficients c = randomCoefficients(kMaxBands, rng);
  const auto energy = [](const Coefficients& x, int l) {
    double sum = 0.0;
    for (int m = -l; m <= l; ++m) sum += x[index(l, m)] * x[index(l, m)];
    return sum;
  };
  for (const dmat3& matrix : turns()) {
    const Coefficients turned = Rotation(matrix, kMaxBands).apply(c);
    for (int l = 0; l < kMaxBands; ++l) EXPECT_NEAR(energy(turned, l), energy(c, l), 1e-12);
  }
}

TEST(Rotation, AppliesToFewerBandsThanItWasMadeFor) {
  Rng rng(65);
  const Coefficients c = randomCoefficients(3, rng);
  const dmat3 matrix = turnAbout(randomDirection(rng), 1.0);
  EXPECT_EQ(Rotation(matrix, 8).apply(c), Rotation(matrix, 3).apply(c));
}

TEST(RotateAboutZ, EqualsTheGeneralRotation) {
  Rng rng(66);
  const Coefficients c = randomCoefficients(kMaxBands, rng);
  for (const double angle : {0.0, 0.4, kPi / 2.0, kPi, -2.9, 1e-9, 40.0}) {
    const Rotation rotation(turnAbout(dvec3(0, 0, 1), angle), kMaxBands);
    EXPECT_LE(largestDifference(rotateAboutZ(c, angle), rotation.apply(c)), 1e-13);
  }
}

}  // namespace
}  // namespace soffit::sh
