// SPDX-License-Identifier: MIT
#include "core/sh/zonal.h"

#include "core/sh/basis.h"
#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::sh {
namespace {

TEST(ProjectZonal, ClampedCosineMatchesItsClosedForm) {
  const auto lobe = projectZonal([](double cos_theta) { return std::max(cos_theta, 0.0); },
                                 {.bands = 6, .breakpoints = {0.0}});
  // Polynomial on either side of the break, so Gauss-Legendre is exact; only rounding is left.
  constexpr double kRoundoff = 32 * kEps;
  EXPECT_NEAR(lobe[0], std::sqrt(kPi) / 2, kRoundoff);
  EXPECT_NEAR(lobe[1], std::sqrt(kPi / 3), kRoundoff);
  EXPECT_NEAR(lobe[2], std::sqrt(5 * kPi) / 8, kRoundoff);
  EXPECT_NEAR(lobe[3], 0.0, kRoundoff);  // odd degrees above 1 vanish
  EXPECT_LE(largestDifference(kernelFromZonal(lobe), clampedCosineKernel(6)), 4 * kRoundoff);
}

TEST(ClampedCosine, MatchesTheFactorialFormula) {
  const Kernel kernel = clampedCosineKernel(kMaxBands);
  for (int l = 2; l < kMaxBands; l += 2) {
    const double half = std::tgamma(l / 2 + 1.0);
    const double exact = 2.0 * kPi * (l / 2 % 2 == 1 ? 1.0 : -1.0) * std::tgamma(l + 1.0) /
                         ((l + 2.0) * (l - 1.0) * std::pow(2.0, l) * half * half);
    EXPECT_NEAR(kernel[static_cast<std::size_t>(l)], exact, std::abs(exact) * 64 * kEps);
  }
  EXPECT_EQ(kernel[3], 0.0);
}

// Energy of the lobe captured to l = 1, 2, 4, 6, 8 (numerics.md 1.8).
TEST(ClampedCosine, CapturesTheStatedEnergy) {
  const auto zonal = zonalFromKernel(clampedCosineKernel(9));
  const double whole = 2.0 * kPi / 3.0;  // integral of max(0, t)^2
  const std::vector<std::pair<std::size_t, double>> stated{
      {1, 0.875}, {2, 0.9922}, {4, 0.9980}, {6, 0.9992}, {8, 0.9996}};
  for (const auto& [degree, share] : stated) {
    double energy = 0.0;
    for (std::size_t l = 0; l <= degree; ++l) energy += zonal[l] * zonal[l];
    EXPECT_NEAR(energy / whole, share, 6e-5);  // digits as printed
  }
}

TEST(Phong, ExponentOneIsTheClampedCosine) {
  const Kernel cosine = clampedCosineKernel(kMaxBands);
  const Kernel phong = phongKernel(1.0, kMaxBands);
  for (std::size_t l = 0; l < phong.size(); ++l) EXPECT_NEAR(phong[l], cosine[l] / kPi, 8 * kEps);
}

TEST(Phong, MatchesQuadratureToExponent2000) {
  for (const double s : {0.0, 0.5, 2.0, 17.0, 300.0, 2000.0}) {
    // The lobe is about 1/sqrt(s) wide; a break puts nodes there.
    const auto zonal = projectZonal(
        [=](double t) { return t > 0.0 ? (s + 1.0) / (2.0 * kPi) * std::pow(t, s) : 0.0; },
        {.bands = kMaxBands, .breakpoints = {0.0, std::pow(1e-3, 2.0 / (s + 2.0))}, .nodes = 200});
    const double tolerance = s == 0.5 ? 1e-6 : 2e-11;  // sqrt(t) is no polynomial
    EXPECT_LE(largestDifference(kernelFromZonal(zonal), phongKernel(s, kMaxBands)), tolerance) << s;
  }
}

TEST(VonMisesFisher, MatchesQuadratureAndItsApproximationIsAsStated) {
  for (const double kappa : {0.0, 0.3, 1.0, 10.0, 50.0, 500.0}) {
    // Scaled by e^-kappa: kappa / (2 pi (1 - e^-2kappa)) e^(kappa (t - 1)).
    const auto lobe = [=](double t) {
      if (kappa == 0.0) return 1.0 / (4.0 * kPi);
      return kappa / (2.0 * kPi * -std::expm1(-2.0 * kappa)) * std::exp(kappa * (t - 1.0));
    };
    const auto zonal =
        projectZonal(lobe, {.bands = kMaxBands, .breakpoints = {0.9, 0.5}, .nodes = 100});
    const Kernel kernel = vonMisesFisherKernel(kappa, kMaxBands);
    EXPECT_LE(largestDifference(kernelFromZonal(zonal), kernel), 1e-11) << kappa;
    if (kappa < 10.0) continue;
    const double stated = kappa < 50.0 ? 0.11 : 0.011;
    EXPECT_LE(largestDifference(vonMisesFisherApproximation(kappa, kMaxBands), kernel), stated);
  }
}

TEST(Ggx, RoughnessOneIsTheClampedCosine) {
  const Kernel cosine = clampedCosineKernel(kMaxBands);
  const Kernel ggx = ggxHalfVectorKernel(1.0, kMaxBands);
  for (std::size_t l = 0; l < ggx.size(); ++l) EXPECT_NEAR(ggx[l], cosine[l] / kPi, 64 * kEps);
}

TEST(Ggx, HalfVectorKernelMatchesDirectQuadrature) {
  for (const double alpha : {0.2, 0.5, 0.9}) {
    const double a2 = alpha * alpha;
    const auto d_cos = [=](double t) {
      const double q = t * t * (a2 - 1.0) + 1.0;
      return t > 0.0 ? a2 / (kPi * q * q) * t : 0.0;
    };
    const auto zonal = projectZonal(
        d_cos, {.bands = kMaxBands, .breakpoints = {0.0, 0.5, 0.9, 0.98}, .nodes = 100});
    EXPECT_LE(largestDifference(kernelFromZonal(zonal), ggxHalfVectorKernel(alpha, kMaxBands)),
              1e-12);
  }
}

// The reflected lobe: degree 4 and 9 as numerics.md 1.8 states them.
TEST(Ggx, ReflectedKernelHasTheStatedFigures) {
  const double figures[5][3] = {{0.1, 0.648, 0.303},
                                {0.2, 0.33, 0.058},
                                {0.3, 0.152, 0.009},
                                {0.4, 0.064, 0.001},
                                {0.5, 0.024, 0.0}};
  for (const auto& [alpha, k4, k9] : figures) {
    const Kernel kernel = ggxReflectedKernel(alpha, kMaxBands);
    EXPECT_NEAR(kernel[0], 1.0, 64 * kEps);
    EXPECT_NEAR(kernel[4], k4, alpha == 0.2 ? 5e-3 : 6e-4) << alpha;  // digits as printed
    EXPECT_NEAR(kernel[9], k9, 6e-4) << alpha;
  }
}

TEST(Ggx, TendsToAMirror) {
  // 1 - k_l is l (l + 1) alpha^2 times a logarithm of alpha, below 40.
  for (const double k : ggxReflectedKernel(1e-4, kMaxBands)) EXPECT_NEAR(k, 1.0, 90 * 1e-8 * 40);
}

TEST(Cap, MatchesTheTextbookWhereThatDoesNotCancel) {
  for (const double sine : {0.1, 0.5, 0.9, 1.0}) {
    const double c = std::sqrt(1.0 - sine * sine);
    const auto p = legendreValues(c, kMaxBands);
    const Kernel kernel = capKernel(sine, kMaxBands - 1);
    EXPECT_NEAR(kernel[0], 2.0 * kPi * (1.0 - c), 16 * kEps);
    for (std::size_t l = 1; l < kernel.size(); ++l) {
      const double textbook = 2.0 * kPi * (p[l - 1] - p[l + 1]) / (2.0 * double(l) + 1.0);
      EXPECT_NEAR(kernel[l], textbook, 64 * kEps);
    }
  }
}

TEST(Cap, KeepsAllDigitsAtADistance) {
  const double sine = 1e-7;
  const Kernel kernel = capKernel(sine, kMaxBands);
  // Every P_l is 1 - l(l+1) sine^2 / 8 over so small a cap: 1e-12 below 1.
  for (const double k : kernel) EXPECT_NEAR(k / (kPi * sine * sine), 1.0, 1e-12);
  EXPECT_EQ(largest(capKernel(0.0, 4)), 0.0);
}

TEST(Zonal, AboutAnAxisIsTheFunctionOfTheAngle) {
  Rng rng(42);
  const Kernel kernel = phongKernel(3.0, 8);
  const auto along_z = zonalFromKernel(kernel);
  for (int i = 0; i < 20; ++i) {
    const dvec3 axis = randomDirection(rng), d = randomDirection(rng);
    const Coefficients c = zonalAbout(kernel, axis);
    const double t = glm::dot(axis, d);
    Coefficients polar(coefficientCount(8), 0.0);
    for (int l = 0; l < 8; ++l) polar[index(l, 0)] = along_z[static_cast<std::size_t>(l)];
    const dvec3 beside(std::sqrt(std::max(0.0, 1.0 - t * t)), 0.0, t);
    EXPECT_NEAR(reconstruct(c, d), reconstruct(polar, beside),
                1e-7);  // sqrt(1 - t^2) near the pole
  }
}

TEST(Zonal, SlopesAreTheDerivatives) {
  constexpr double kStep = 1e-6;
  const auto high = legendreValues(0.3 + kStep, kMaxBands);
  const auto low = legendreValues(0.3 - kStep, kMaxBands);
  const auto slope = legendreSlopes(0.3, kMaxBands);
  for (std::size_t l = 0; l < slope.size(); ++l) {
    EXPECT_NEAR(slope[l], (high[l] - low[l]) / (2.0 * kStep), 1e-8);  // h^2 and eps / h
  }
}

}  // namespace
}  // namespace soffit::sh
