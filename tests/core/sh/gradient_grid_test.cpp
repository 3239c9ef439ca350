// SPDX-License-Identifier: MIT
#include "core/sh/gradient_grid.h"

#include "core/sh/convolution.h"
#include "core/sh/sphere_light.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::sh {
namespace {

const std::array<dvec3, 4> kPanel{dvec3(-0.6, -0.3, 2.5), dvec3(-0.6, 0.3, 2.5),
                                  dvec3(0.6, 0.3, 2.5), dvec3(0.6, -0.3, 2.5)};

CoefficientsWithGradient panelAt(const dvec3& p) {
  return polygonCoefficientsWithGradient(kPanel, p, 5);
}

/// Largest error at random places of the grid's box, relative to the largest coefficient there.
double worst(const GradientGrid& grid, const dvec3& lo, const dvec3& hi) {
  Rng rng(111);
  double error = 0.0, size = 0.0;
  Coefficients c(25);
  for (int i = 0; i < 30000; ++i) {
    // Braces: compilers differ in the order of a call's arguments.
    const dvec3 p =
        lo + (hi - lo) * dvec3{rng.uniformDouble(), rng.uniformDouble(), rng.uniformDouble()};
    const Coefficients exact = polygonCoefficients(kPanel, p, 5);
    grid.at(p, c);
    error = std::max(error, largestDifference(c, exact));
    size = std::max(size, largest(exact));
  }
  return error / size;
}

GradientGrid gridOf(int cells) {
  return GradientGrid({dvec3(-2, -2, 0),
                       dvec3(4.0 / cells, 4.0 / cells, 1.0 / cells),
                       {cells + 1, cells + 1, cells + 1}},
                      panelAt);
}

TEST(GradientGrid, IsExactForQuadratics) {
  const auto quadratic = [](const dvec3& p) {
    CoefficientsWithGradient c{{1.0 + p.x * p.y - p.z * p.z + 2.0 * p.x * p.x}, {}};
    c.gradients = {{p.y + 4.0 * p.x, p.x, -2.0 * p.z}};
    return c;
  };
  const GradientGrid grid({dvec3(-1, 0, 2), dvec3(0.5, 1.0, 0.7), {4, 3, 5}}, quadratic);
  Rng rng(112);
  std::array<double, 1> c;
  for (int i = 0; i < 100; ++i) {
    const dvec3 p(1.5 * rng.uniformDouble() - 1.0, 2.0 * rng.uniformDouble(),
                  2.0 + 2.8 * rng.uniformDouble());
    grid.at(p, c);
    EXPECT_NEAR(c[0], quadratic(p).values[0], 100 * kEps);
  }
}

TEST(GradientGrid, ErrorFallsWithTheThirdPowerOfTheSpacing) {
  const double coarse = worst(gridOf(6), dvec3(-2, -2, 0), dvec3(2, 2, 1));
  const double fine = worst(gridOf(12), dvec3(-2, -2, 0), dvec3(2, 2, 1));
  EXPECT_LT(fine, coarse / 6.0);  // an eighth or less, once the spacing is small
  EXPECT_LT(fine, 7e-3);          // 6.3e-3 at the worst of 30,000 places
}

// product.md: the same picture at a tenth of the evaluations. 10,000 receivers on a floor of 4 x 4
// m.
TEST(GradientGrid, LightsAFloorAtATenthOfTheEvaluations) {
  const GradientGrid grid({dvec3(-2, -2, 0), dvec3(4.0 / 29, 4.0 / 29, 1.0), {30, 30, 1}}, panelAt);
  EXPECT_LE(grid.evaluations(), 1000U);
  Coefficients c(25);
  double worst_e = 0.0, peak = 0.0;
  for (int i = 0; i < 10000; i += 7) {
    const dvec3 p(-2.0 + 4.0 * (i % 100) / 99.0, -2.0 + 4.0 * (i / 100) / 99.0, 0.0);
    grid.at(p, c);
    const double e = irradiance(polygonCoefficients(kPanel, p, 5), dvec3(0, 0, 1));
    worst_e = std::max(worst_e, std::abs(irradiance(c, dvec3(0, 0, 1)) - e));
    peak = std::max(peak, e);
  }
  EXPECT_LT(worst_e, 1e-4 * peak);
}

TEST(GradientGrid, GivesBackItsPointsAndGoesOnBeyondItsEdges) {
  const auto sphere = [](const dvec3& p) {
    return sphereCoefficientsWithGradient(dvec3(0, 0, 4), 0.3, p, 4);
  };
  const GridPlaces places{dvec3(0), dvec3(0.5), {3, 2, 2}};
  const GradientGrid grid(places, sphere);
  Coefficients c(16);
  for (std::size_t i = 0; i < places.size(); ++i) {
    grid.at(places.at(i), c);
    EXPECT_LE(largestDifference(c, sphere(places.at(i)).values), 8 * kEps);
  }
  // 1 cm outside: first order, of which half is left out at the edge.
  grid.at(dvec3(-0.01, -0.01, -0.01), c);
  EXPECT_LE(largestDifference(c, sphere(dvec3(-0.01)).values), 0.01 * largest(c));
  const GradientGrid single({dvec3(0), dvec3(1), {1, 1, 1}}, sphere);
  single.at(dvec3(0.01, 0, 0), c);
  EXPECT_LE(largestDifference(c, sphere(dvec3(0)).at(dvec3(0.01, 0, 0))), 8 * kEps);
}

}  // namespace
}  // namespace soffit::sh
