// SPDX-License-Identifier: MIT
#include "core/photometry/symmetry.h"

#include "tests/core/photometry/distributions.h"

#include <gtest/gtest.h>

namespace soffit::photometry {
namespace {

TEST(Symmetry, IsFoundFromTheIntensities) {
  const auto found = [](const std::function<double(double, double)>& f) {
    return detectSymmetry(tabulate(f, 24, 19));
  };
  EXPECT_EQ(found([](double, double g) { return 1 + std::cos(g); }), Symmetry::axial);
  EXPECT_EQ(found([](double c, double) { return 2 + std::cos(2 * c); }), Symmetry::quadrant);
  EXPECT_EQ(found([](double c, double) { return 2 + std::cos(c); }), Symmetry::about_c0);
  EXPECT_EQ(found([](double c, double) { return 2 + std::sin(c); }), Symmetry::about_c90);
  EXPECT_EQ(found([](double c, double) { return 3 + std::sin(c) + std::cos(c); }), Symmetry::none);
}

TEST(Symmetry, ToleranceIsAShareOfThePeak) {
  const auto d = tabulate([](double c, double) { return 100 + 0.5 * std::sin(c + 1); }, 24, 3);
  EXPECT_EQ(detectSymmetry(d), Symmetry::none);
  EXPECT_EQ(detectSymmetry(d, 0.02), Symmetry::axial);
}

TEST(Symmetry, UnevenPlanesAreComparedWithTheirInterpolatedImages) {
  IntensityDistribution d;
  d.c_deg = {0.0, 10.0, 180.0};
  d.gamma_deg = {0.0, 180.0};
  d.candela = {1, 1, 2, 2, 1, 1};
  EXPECT_EQ(detectSymmetry(d), Symmetry::none);
}

TEST(Symmetry, EachHasItsOwnName) {
  EXPECT_EQ(symmetryName(Symmetry::axial), "axial");
  EXPECT_EQ(symmetryName(Symmetry::quadrant), "quadrant");
  EXPECT_EQ(symmetryName(Symmetry::about_c0), "bilateral about C0-C180");
  EXPECT_EQ(symmetryName(Symmetry::about_c90), "bilateral about C90-C270");
  EXPECT_EQ(symmetryName(Symmetry::none), "none");
}

}  // namespace
}  // namespace soffit::photometry
