// SPDX-License-Identifier: MIT
#include "core/glossy/bands.h"

#include "core/glossy/ggx.h"
#include "core/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::glossy {
namespace {

TEST(Bands, OrderServesRoughnessAsNumericsSays) {
  EXPECT_EQ(bandsFor(0.4), 5);   // numerics.md 1.8: k_4 = 0.064
  EXPECT_EQ(bandsFor(0.2), 10);  // k_9 = 0.058
  EXPECT_EQ(bandsFor(0.1), std::nullopt);
  EXPECT_EQ(bandsFor(1.0), 3);  // never fewer than 9 coefficients
  for (int bands = 3; bands <= sh::kMaxBands; ++bands) {
    const double least = leastAlphaFor(bands);
    EXPECT_LE(bandsFor(least + 1e-5).value(), bands);
    EXPECT_NE(bandsFor(least - 1e-5), bands);
  }
}

TEST(Bands, PointLightErrorIsTheRestOfTheLobesEnergy) {
  // The lobe less its first bands, squared and integrated over the sphere.
  for (const double alpha : {0.2, 0.4, 0.8}) {
    const int bands = 5;
    const sh::Kernel kernel = sh::ggxReflectedKernel(alpha, bands);
    const QuadratureRule rule = gaussLegendre(400, -1.0, 1.0);
    double lost = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double t = rule.nodes[i];
      const double lobe = 0.25 * ggxDensity(std::sqrt(0.5 * (1.0 + t)), alpha);
      const std::vector<double> p = sh::legendreValues(t, bands);
      double kept = 0.0;
      for (std::size_t l = 0; l < p.size(); ++l) {
        kept += (2.0 * static_cast<double>(l) + 1.0) / (4.0 * kPi) * kernel[l] * p[l];
      }
      lost += rule.weights[i] * (lobe - kept) * (lobe - kept);
      whole += rule.weights[i] * lobe * lobe;
    }
    EXPECT_NEAR(pointLightError(alpha, bands), std::sqrt(lost / whole), 1e-6);
  }
}

TEST(Bands, RoundLobeOfAlphaOneLosesNothing) {
  // alpha = 1 reflects evenly over the sphere: one coefficient is all there is. The root makes
  // 1e-8 of a rounding error of 1e-16.
  EXPECT_NEAR(pointLightError(1.0, 3), 0.0, 1e-7);
  EXPECT_NEAR(edgeError(1.0, 3), 0.0, 1e-7);
}

TEST(Bands, ErrorsFallWithBandsAndRoughness) {
  for (const double alpha : {0.05, 0.1, 0.2, 0.4}) {
    for (int bands = 3; bands < sh::kMaxBands; ++bands) {
      EXPECT_LE(pointLightError(alpha, bands + 1), pointLightError(alpha, bands));
      EXPECT_LE(edgeError(alpha, bands + 1), edgeError(alpha, bands));
      EXPECT_LT(pointLightError(2.0 * alpha, bands), pointLightError(alpha, bands));
    }
  }
  // What "served" means: an edge is right to 2 % of its height.
  for (int bands = 4; bands <= sh::kMaxBands; ++bands) {
    EXPECT_LT(edgeError(leastAlphaFor(bands), bands), 0.02) << bands;
  }
}

TEST(Bands, PhongExponentHasTheSameMeanCosine) {
  for (const double alpha : {0.02, 0.1, 0.3}) {
    const double s = phongExponentFor(alpha);
    EXPECT_NEAR(sh::phongKernel(s, 2)[1], sh::ggxReflectedKernel(alpha, 2)[1], 1e-12);
  }
  EXPECT_EQ(phongExponentFor(1.0), 0.0);
}

}  // namespace
}  // namespace soffit::glossy
