// SPDX-License-Identifier: MIT
#include "core/glossy/transfer_matrix.h"

#include "core/glossy/bands.h"
#include "core/glossy/lobe_shape.h"
#include "core/sh/basis.h"
#include "core/sh/convolution.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

constexpr double kRoundoff = 1e-12;

sh::Coefficients randomCoefficients(std::size_t count, Rng& rng) {
  sh::Coefficients c(count);
  for (double& x : c) x = 2.0 * rng.uniformDouble() - 1.0;
  return c;
}

std::vector<double> times(const std::vector<double>& matrix, const sh::Coefficients& v) {
  std::vector<double> product(matrix.size() / v.size(), 0.0);
  for (std::size_t i = 0; i < product.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) product[i] += matrix[i * v.size() + j] * v[j];
  }
  return product;
}

TEST(TransferMatrix, OfNothingInTheWayIsTheIdentity) {
  const sh::SphereSamples samples = sh::cubature(8);  // exact for products of two of degree 4
  VisibilityBits bits(1, samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) bits.setOpen(0, k);
  const std::vector<double> matrix = matrixFromBits(bits, 0, samples, 5);
  for (std::size_t i = 0; i < 25; ++i) {
    for (std::size_t j = 0; j < 25; ++j) {
      EXPECT_NEAR(matrix[i * 25 + j], i == j ? 1.0 : 0.0, kRoundoff);
    }
  }
}

TEST(TransferMatrix, FromBitsEqualsTripleProductsOfTwiceTheBands) {
  // The same samples on both sides, so only rounding is left: products of two harmonics below
  // degree n have degrees below 2n - 1, and the tensor is exact there.
  Rng rng(3);
  const sh::SphereSamples samples = sh::hammersleySamples(500);
  for (int bands = 1; bands <= kMaxMatrixBands; ++bands) {
    VisibilityBits bits(1, samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (rng.uniform() < 0.4F) bits.setOpen(0, k);
    }
    const std::vector<double> direct = matrixFromBits(bits, 0, samples, bands);
    const std::vector<double> tensor =
        matrixFromVisibility(visibilityCoefficients(bits, 0, samples, 2 * bands - 1), bands);
    for (std::size_t i = 0; i < direct.size(); ++i) EXPECT_NEAR(direct[i], tensor[i], kRoundoff);
  }
}

TEST(TransferMatrix, VisibilityOfTheLightsOwnBandsLosesPartOfTheProduct) {
  // What Dhawal et al. 2022 take: 5 bands for all three. The matrix of a half-open sky differs.
  const sh::SphereSamples samples = sh::cubature(62);
  VisibilityBits bits(1, samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples.directions[k].z > 0.0) bits.setOpen(0, k);
  }
  const auto lost = [&](int visibility_bands) {
    const std::vector<double> exact = matrixFromBits(bits, 0, samples, 5);
    const std::vector<double> cut =
        matrixFromVisibility(visibilityCoefficients(bits, 0, samples, visibility_bands), 5);
    double error = 0.0, size = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      error += (cut[i] - exact[i]) * (cut[i] - exact[i]);
      size += exact[i] * exact[i];
    }
    return std::sqrt(error / size);
  };
  EXPECT_NEAR(lost(9), 0.0, kRoundoff);
  EXPECT_GT(lost(5), 0.1);
  EXPECT_LT(lost(7), lost(5));
}

TEST(TransferMatrix, FixedLightAndMatrixAndTripleProductAgree) {
  Rng rng(8);
  for (const int bands : {3, 4, 5}) {
    const sh::Coefficients light = randomCoefficients(sh::coefficientCount(bands), rng);
    for (const int visibility_bands : {bands, 2 * bands - 1}) {
      const sh::Coefficients v = randomCoefficients(sh::coefficientCount(visibility_bands), rng);
      const std::vector<double> by_matrix = times(matrixFromVisibility(v, bands), light);
      const std::vector<double> by_light = times(fixedLightMatrix(light, visibility_bands), v);
      for (std::size_t i = 0; i < light.size(); ++i) {
        EXPECT_NEAR(by_matrix[i], by_light[i], kRoundoff);
      }
      if (visibility_bands != bands) continue;
      sh::Coefficients product(light.size());
      sh::TripleProduct::ofBands(bands).multiply(std::span<const double>(light), v, product);
      for (std::size_t i = 0; i < light.size(); ++i) {
        EXPECT_NEAR(by_matrix[i], product[i], kRoundoff);
      }
    }
  }
}

TEST(TransferMatrix, RadianceIsTheConvolutionAtTheAxis) {
  Rng rng(2);
  const sh::Coefficients light = randomCoefficients(25, rng);
  const dvec3 axis = randomDirection(rng);
  const auto& kernel = lobeKernel(0.4);
  const sh::Kernel whole(kernel.begin(), kernel.begin() + 5);
  EXPECT_NEAR(glossyRadiance(light, kernel, axis),
              sh::reconstruct(sh::convolve(light, whole), axis), kRoundoff);
}

TEST(TransferMatrix, UniformLightOverOpenGroundGivesTheReflectance) {
  // White furnace: the upper half of the sky is open and 1 cd/m2 everywhere. Error: the cut-off
  // of the half sphere's edge after the lobe (edgeError(), RMS; the axis is where it may be larger)
  // and the lobe's table. The cubature has no node in the horizon.
  const sh::SphereSamples samples = sh::cubature(62);
  VisibilityBits bits(1, samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples.directions[k].z > 0.0) bits.setOpen(0, k);
  }
  const sh::Coefficients sky{2.0 * std::sqrt(kPi)};
  sh::Coefficients light(25, 0.0);
  light[0] = sky[0];
  const std::vector<double> arriving = times(matrixFromBits(bits, 0, samples, 5), light);
  for (const double alpha : {0.45, 0.7, 1.0}) {
    for (const double cosine : {0.3, 0.6, 1.0}) {
      const LobeShape shape = lobeShape(cosine, alpha);
      double radiance = 0.0;
      double cut = 0.0;
      for (const auto& [factor, lobe] :
           {std::pair(0.8 * shape.scale, shape.base), std::pair(shape.bias, shape.rise)}) {
        const dvec3 axis(lobe.axis_sine, 0.0, std::sqrt(1.0 - lobe.axis_sine * lobe.axis_sine));
        radiance += factor / lobe.above * glossyRadiance(arriving, lobeKernel(lobe.alpha), axis);
        cut = std::max(cut, edgeError(lobe.alpha, 5));
      }
      EXPECT_NEAR(radiance / shape.reflectance(0.8), 1.0, 0.02 + 3.0 * cut)
          << alpha << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace soffit::glossy
