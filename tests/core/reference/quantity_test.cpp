// SPDX-License-Identifier: MIT
#include "rooms.h"

#include "core/math/sampling.h"
#include "core/reference/quantity.h"

#include <gtest/gtest.h>

namespace soffit::reference {
namespace {

using test::measure;

const Quantity kAll[] = {Quantity::planar, Quantity::cylindrical, Quantity::semicylindrical,
                         Quantity::spherical, Quantity::hemispherical};

TEST(Response, UniformRadianceGivesTheIntegralOfTheWeight) {
  // Integral of W over all directions: pi for bodies that see it all from every face.
  for (const Quantity quantity : kAll) {
    const dvec3 n = glm::normalize(dvec3(0.3, -0.5, 0.1));
    const Response response(quantity, n);
    constexpr std::uint32_t kCount = 1U << 16U;
    double by_sphere = 0.0;
    double by_own = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const dvec2 u = r2Sequence(i);
      const dvec3 w(uniformSphere(float(u.x), float(u.y)));
      by_sphere += response.weight(w) * 4.0 * kPi / kCount;
      const dvec3 own = response.sample(u);
      by_own += response.weight(own) / response.density(own) / kCount;
    }
    // Truncation of 65536 low-discrepancy points on an integrand with a bend.
    EXPECT_NEAR(by_sphere, kPi, 1e-3) << int(quantity);
    EXPECT_NEAR(by_own, kPi, 1e-3) << int(quantity);
  }
}

TEST(Response, MatchesItsBodies) {
  const dvec3 up(0, 0, 1);
  const dvec3 slant = glm::normalize(dvec3(3, 0, 4));
  EXPECT_NEAR(Response(Quantity::planar, up).weight(slant), 0.8, 1e-15);
  EXPECT_EQ(Response(Quantity::planar, up).weight(-slant), 0.0);
  EXPECT_NEAR(Response(Quantity::cylindrical, up).weight(slant), 0.6 / kPi, 1e-15);
  EXPECT_NEAR(Response(Quantity::cylindrical, up).weight(-slant), 0.6 / kPi, 1e-15);
  EXPECT_NEAR(Response(Quantity::semicylindrical, {1, 0, 0}).weight(slant), 1.2 / kPi, 1e-15);
  EXPECT_NEAR(Response(Quantity::semicylindrical, {-1, 0, 0}).weight(slant), 0.0, 1e-15);
  EXPECT_NEAR(Response(Quantity::semicylindrical, {0, 1, 0}).weight(slant), 0.6 / kPi, 1e-15);
  EXPECT_NEAR(Response(Quantity::spherical, up).weight(slant), 0.25, 1e-15);
  EXPECT_NEAR(Response(Quantity::hemispherical, up).weight(slant), 0.45, 1e-15);
}

TEST(Response, AVerticalViewHasSomeCylinderStill) {
  const Response response(Quantity::semicylindrical, {0, 0, 1});
  EXPECT_TRUE(std::isfinite(response.weight({1, 0, 0})));
}

TEST(Quantities, OfAPointSourceAreTheirWeightsTimesIntensityOverDistanceSquared) {
  light::Luminaire l = test::luminaire(light::PointShape{}, {3, 0, 4});
  l.distribution.kind = light::DistributionKind::isotropic;
  const ReferenceScene scene = test::prepare(test::Builder().scene(), {l});
  EstimateOptions options;
  options.min_replicates = 2;
  for (const Quantity quantity : kAll) {
    options.quantity = quantity;
    const dvec3 n = quantity == Quantity::semicylindrical ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
    const double expected =
        1000.0 / (4.0 * kPi) / 25.0 * Response(quantity, n).weight({0.6, 0.0, 0.8});
    const SensorEstimate e = measure(scene, {dvec3(0), n}, options);
    EXPECT_NEAR(e.direct, expected, 1e-12 * expected + 1e-13);  // round-off: no randomness left
    EXPECT_EQ(e.indirect, 0.0);
  }
}

}  // namespace
}  // namespace soffit::reference
