// SPDX-License-Identifier: MIT
#include "core/sh/sphere_light.h"

#include "core/sh/basis.h"
#include "core/sh/convolution.h"
#include "core/sh/projection.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

namespace soffit::sh {
namespace {

TEST(SphereLight, MatchesProjectionOfItsCap) {
  // The cap about its axis by a zonal rule with a break at its edge, then turned.
  Rng rng(101);
  for (const double distance : {1.05, 2.0, 30.0}) {
    const dvec3 axis = randomDirection(rng);
    const double edge = std::sqrt(1.0 - 1.0 / (distance * distance));
    const auto zonal = projectZonal([=](double t) { return t > edge ? 1.0 : 0.0; },
                                    {.bands = kMaxBands, .breakpoints = {edge}});
    const Coefficients exact = zonalAbout(kernelFromZonal(zonal), axis);
    const Coefficients c = sphereCoefficients(distance * axis, 1.0, dvec3(0), kMaxBands);
    EXPECT_LE(largestDifference(c, exact), 1e-12);
  }
}

TEST(SphereLight, IrradianceFacingItIsPiTimesSineSquared) {
  // E = pi L (R / r)^2; what 10 bands miss is seen at grazing angles, not here.
  const Coefficients c = sphereCoefficients(dvec3(0, 0, 3), 1.0, dvec3(0), kMaxBands);
  EXPECT_NEAR(irradiance(c, dvec3(0, 0, 1)), kPi / 9.0, 0.01 * kPi / 9.0);
}

TEST(SphereLight, GivesNothingInsideOrWithoutSize) {
  EXPECT_EQ(largest(sphereCoefficients(dvec3(0, 0, 0.5), 1.0, dvec3(0), 4)), 0.0);
  EXPECT_EQ(largest(sphereCoefficients(dvec3(0, 0, 0.5), 0.0, dvec3(0), 4)), 0.0);
  EXPECT_EQ(largest(sphereCoefficients(dvec3(0), 1.0, dvec3(0), 4)), 0.0);
  EXPECT_EQ(largest(sphereCoefficientsWithGradient(dvec3(0), 1.0, dvec3(0), 4).values), 0.0);
}

TEST(SphereLight, GradientsAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  const dvec3 center(0.4, -0.7, 1.1);
  for (const dvec3& p : {dvec3(0), dvec3(0.4, -0.7, 0.0), dvec3(3, 2, -1)}) {
    const auto at = sphereCoefficientsWithGradient(center, 0.5, p, kMaxBands);
    EXPECT_LE(largestDifference(at.values, sphereCoefficients(center, 0.5, p, kMaxBands)), 1e-14);
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0.0);
      step[axis] = kStep;
      const Coefficients low = sphereCoefficients(center, 0.5, p - step, kMaxBands);
      const Coefficients high = sphereCoefficients(center, 0.5, p + step, kMaxBands);
      for (std::size_t i = 0; i < low.size(); ++i) {
        EXPECT_NEAR(at.gradients[i][axis], (high[i] - low[i]) / (2.0 * kStep), 1e-7) << i;
      }
    }
  }
}

}  // namespace
}  // namespace soffit::sh
