// SPDX-License-Identifier: MIT
#include "core/glossy/ltc.h"

#include "core/glossy/ggx.h"
#include "core/math/quadrature.h"
#include "tests/core/glossy/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

TEST(Ltc, DensityHasUnitWeightAtEveryNode) {
  // Cosine-distributed points through M carry the density with weight 1: the mean of density(w) /
  // density by the map is 1, which tests inverse and Jacobian against the matrix.
  Rng rng(3);
  for (int k = 0; k < 50; ++k) {
    const Ltc ltc = ltcAt(rng.uniformDouble(), rng.uniformDouble());
    for (int i = 0; i < 20; ++i) {
      const dvec3 c = upperDirection(rng);
      const dvec3 stretched = ltc.matrix * c;
      const double length = glm::length(stretched);
      EXPECT_NEAR(
          ltc.density(stretched / length) / (c.z / kPi * ltc.jacobian * length * length * length),
          1.0, 1e-9);
    }
    EXPECT_NEAR(glm::determinant(ltc.matrix) * ltc.jacobian, 1.0, 1e-9);
    EXPECT_GT(glm::determinant(ltc.matrix), 0.0);
  }
}

TEST(Ltc, RoundAboutTheNormal) {
  for (const double alpha : {0.01, 0.2, 0.8}) {
    const Ltc ltc = ltcAt(1.0, alpha);
    EXPECT_NEAR(ltc.matrix[0][0], ltc.matrix[1][1], 1e-12);
    EXPECT_NEAR(ltc.matrix[0][2], 0.0, 1e-12);
    EXPECT_NEAR(ltc.matrix[2][0], 0.0, 1e-12);
  }
}

/// The share of both densities that does not overlap, 1/2 integral |difference|.
double misplaced(const Ltc& ltc, double cosine, double alpha) {
  const dvec3 wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  constexpr int kSide = 200;
  double weight = 0.0, overlap = 0.0;
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const GgxDraw d = drawGgx(wo, alpha, {(i + 0.5) / kSide, (j + 0.5) / kSide});
        if (d.weight <= 0.0) continue;
        if (pass == 0) {
          weight += d.weight / (kSide * kSide);
        } else {
          // Samples of the lobe: the mean of min(1, fit / lobe) is what they share.
          const double lobe = ggxLobe(wo, d.wi, alpha) / weight;
          overlap += d.weight / weight * std::min(1.0, ltc.density(d.wi) / lobe);
        }
      }
    }
  }
  return 1.0 - overlap / (kSide * kSide);
}

TEST(Ltc, MisplacesLittleOfTheLobe) {
  // Stated in core/glossy/README.md. The tails of GGX are longer than a cosine's.
  double worst_near = 0.0, worst_far = 0.0;
  for (const double roughness : {0.1, 0.25, 0.4, 0.5, 0.7, 1.0}) {
    const double alpha = roughness * roughness;
    for (const double angle : {0.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
      const double share =
          misplaced(ltcAt(std::cos(radians(angle)), alpha), std::cos(radians(angle)), alpha);
      (angle <= 60.0 ? worst_near : worst_far) =
          std::max(angle <= 60.0 ? worst_near : worst_far, share);
    }
  }
  EXPECT_LT(worst_near, 0.14);  // to 60 degrees from the normal
  EXPECT_LT(worst_far, 0.33);   // to 85
}

TEST(Ltc, TableIsAsGoodAsAFit) {
  Rng rng(6);
  for (int k = 0; k < 12; ++k) {
    const double cosine = 0.1 + 0.9 * rng.uniformDouble();
    const double alpha = std::pow(0.1 + 0.9 * rng.uniformDouble(), 2);
    EXPECT_LT(misplaced(ltcAt(cosine, alpha), cosine, alpha),
              misplaced(fitLtc(cosine, alpha), cosine, alpha) + 0.02);
  }
}

}  // namespace
}  // namespace soffit::glossy
