// SPDX-License-Identifier: MIT
#include "core/light/polygon_irradiance.h"

#include "core/light/light_mask.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::light {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Howell C-11 / the textbook's differential element under a rectangle's corner, parallel:
/// F = 1/(2 pi) [X/sqrt(1+X^2) atan(Y/sqrt(1+X^2)) + Y/sqrt(1+Y^2) atan(X/sqrt(1+Y^2))].
double cornerFactor(double x, double y) {
  const double a = std::sqrt(1.0 + x * x);
  const double b = std::sqrt(1.0 + y * y);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2.0 * kPi);
}

std::array<dvec3, 4> ceilingPanel(double w, double h, double z) {
  // Emits down: counter-clockwise seen from below.
  return {dvec3(0, 0, z), dvec3(0, h, z), dvec3(w, h, z), dvec3(w, 0, z)};
}

TEST(PolygonIrradiance, RectangleOverItsCornerMatchesTheTextbook) {
  for (const double z : {0.05, 0.3, 1.0, 10.0, 100.0}) {
    const auto panel = ceilingPanel(1.2, 0.6, z);
    const double expected = kPi * cornerFactor(1.2 / z, 0.6 / z);
    // Cancellation of the boundary sum grows like (z/size)^2.
    EXPECT_NEAR(polygonIrradiance(panel, dvec3(0), dvec3(0, 0, 1)), expected,
                expected * 64 * kEps * (1 + z * z / 0.36));
  }
}

TEST(PolygonIrradiance, FarAwayItIsThePointLight) {
  const auto panel = ceilingPanel(0.1, 0.1, 100.0);
  // (size/distance)^2 = 1e-6 is the truncation of the point formula.
  EXPECT_NEAR(polygonIrradiance(panel, dvec3(0.05, 0.05, 0), dvec3(0, 0, 1)), 0.01 / 1e4,
              0.01 / 1e4 * 2e-6);
}

TEST(PolygonIrradiance, ClippingAtTheHorizonAddsUpOverTwoHalves) {
  // The panel cut by the receiver's plane equals the part above it.
  const std::array<dvec3, 4> wall = {dvec3(1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 1),
                                     dvec3(1, -1, 1)};
  const std::array<dvec3, 4> upper = {dvec3(1, -1, 0), dvec3(1, 1, 0), dvec3(1, 1, 1),
                                      dvec3(1, -1, 1)};
  const double a = polygonIrradiance(wall, dvec3(0), dvec3(0, 0, 1));
  const double b = polygonIrradiance(upper, dvec3(0), dvec3(0, 0, 1));
  // Seen from the receiver one of the two windings is counter-clockwise.
  const std::array<dvec3, 4> wall_back = {wall[3], wall[2], wall[1], wall[0]};
  const std::array<dvec3, 4> upper_back = {upper[3], upper[2], upper[1], upper[0]};
  const double c = polygonIrradiance(wall_back, dvec3(0), dvec3(0, 0, 1));
  const double d = polygonIrradiance(upper_back, dvec3(0), dvec3(0, 0, 1));
  EXPECT_NEAR(a + c, b + d, 16 * kEps);
  EXPECT_GT(a + c, 0.1);
  EXPECT_EQ(std::min(a, c), 0.0);
}

TEST(PolygonIrradiance, NonConvexOutlineIsTheDifferenceOfTwoRectangles) {
  // An L: the 2 x 2 square without its far quarter, also when the horizon cuts it.
  for (const dvec3 n :
       {dvec3(0, 0, 1), glm::normalize(dvec3(1, 0.3, 0.05)), glm::normalize(dvec3(-1, 0.2, 0.1))}) {
    const std::array<dvec3, 6> ell = {dvec3(-1, -1, 1), dvec3(-1, 1, 1), dvec3(0, 1, 1),
                                      dvec3(0, 0, 1),   dvec3(1, 0, 1),  dvec3(1, -1, 1)};
    const std::array<dvec3, 4> full = {dvec3(-1, -1, 1), dvec3(-1, 1, 1), dvec3(1, 1, 1),
                                       dvec3(1, -1, 1)};
    const std::array<dvec3, 4> quarter = {dvec3(0, 0, 1), dvec3(0, 1, 1), dvec3(1, 1, 1),
                                          dvec3(1, 0, 1)};
    EXPECT_NEAR(polygonIrradiance(ell, dvec3(0), n),
                polygonIrradiance(full, dvec3(0), n) - polygonIrradiance(quarter, dvec3(0), n),
                32 * kEps);
  }
}

TEST(PolygonIrradiance, BehindTheLightOrFacingAwayIsDark) {
  const auto panel = ceilingPanel(1, 1, 2);
  EXPECT_EQ(polygonIrradiance(panel, dvec3(0.5, 0.5, 3), dvec3(0, 0, -1)), 0.0);
  EXPECT_EQ(polygonIrradiance(panel, dvec3(0.5, 0.5, 0), dvec3(0, 0, -1)), 0.0);
}

TEST(DiskIrradiance, OnAxisAndAgainstAPolygon) {
  for (const double d : {0.05, 0.5, 5.0, 100.0}) {
    const double a = 0.3;
    EXPECT_NEAR(diskIrradiance(dvec3(0, 0, d), dvec3(0, 0, -1), a, dvec3(0), dvec3(0, 0, 1)),
                kPi * a * a / (a * a + d * d), 8 * kEps);
  }
  // Any orientation: a 4096-gon of the same area differs by O(1/4096^2).
  Rng rng(7);
  for (int trial = 0; trial < 200; ++trial) {
    const dvec3 p(4 * rng.uniformDouble() - 2, 4 * rng.uniformDouble() - 2,
                  -0.05 - 2 * rng.uniformDouble());
    const dvec3 n = dvec3(uniformSphere(rng.uniform(), rng.uniform()));
    ContourSum sum(n);
    constexpr int kCorners = 4096;
    const double step = 2 * kPi / kCorners;
    for (int i = 0; i < kCorners; ++i) {
      sum.vertex(0.5 * std::sqrt(step / std::sin(step)) *
                     dvec3(std::cos(-i * step), std::sin(-i * step), 0) +
                 dvec3(0, 0, 0) - p);
    }
    const double exact = sum.value();
    EXPECT_NEAR(diskIrradiance(dvec3(0), dvec3(0, 0, -1), 0.5, p, n), exact, 2e-6) << trial;
  }
}

TEST(SphereIrradiance, FullPartialAndAgainstSampling) {
  EXPECT_NEAR(sphereIrradiance(dvec3(0, 0, 2), 0.5, dvec3(0), dvec3(0, 0, 1)), kPi / 16, 4 * kEps);
  // Centre on the horizon: half of the sphere's projected solid angle is left; by symmetry the
  // answer is independent of azimuth and falls to 0 at -asin(R/d).
  const double at_horizon = sphereIrradiance(dvec3(2, 0, 0), 0.5, dvec3(0), dvec3(0, 0, 1));
  double sum = 0;  // cone sampling with stratified numbers
  const double cos_cap = std::sqrt(1 - 1.0 / 16);
  constexpr int kSide = 1000;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double c = 1 - (i + 0.5) / kSide * (1 - cos_cap);
      const double phi = 2 * kPi * (j + 0.5) / kSide;
      sum += std::max(0.0, std::sqrt(1 - c * c) * std::cos(phi));
    }
  }
  EXPECT_NEAR(at_horizon, sum * 2 * kPi * (1 - cos_cap) / (kSide * kSide),
              1e-6);  // midpoint rule, 1/kSide^2
  EXPECT_EQ(sphereIrradiance(dvec3(2, 0, -0.6), 0.5, dvec3(0), dvec3(0, 0, 1)), 0.0);
  EXPECT_EQ(sphereIrradiance(dvec3(0), 0.5, dvec3(0.1, 0, 0), dvec3(0, 0, 1)), 0.0);
}

TEST(TubeIrradiance, MatchesAreaIntegrationAndItsClippedForm) {
  const dvec3 axis(1, 0, 0);
  for (const dvec3 n :
       {dvec3(0, 0, 1), glm::normalize(dvec3(0.4, 0.2, 0.5)), glm::normalize(dvec3(1, 0, 0.02))}) {
    const dvec3 center(0.1, 0.2, 0.8);
    double sum = 0;
    constexpr int kAround = 2000;
    constexpr int kAlong = 2000;
    for (int i = 0; i < kAround; ++i) {
      const double phi = 2 * kPi * (i + 0.5) / kAround;
      const dvec3 m(0, std::cos(phi), std::sin(phi));
      for (int j = 0; j < kAlong; ++j) {
        const dvec3 x = center + axis * (1.2 * ((j + 0.5) / kAlong - 0.5)) + 0.1 * m;
        const double r2 = glm::dot(x, x);
        sum += std::max(0.0, glm::dot(n, x)) * std::max(0.0, -glm::dot(m, x)) / (r2 * r2);
      }
    }
    sum *= 1.2 * 2 * kPi * 0.1 / (static_cast<double>(kAround) * kAlong);
    // Midpoint rule with kinks: O(1/kAround^2) on a value of order 0.1.
    EXPECT_NEAR(tubeIrradiance(center, axis, 0.6, 0.1, dvec3(0), n), sum, 5e-6);
  }
  EXPECT_EQ(tubeIrradiance(dvec3(1, 0, 0), axis, 0.6, 0.1, dvec3(0), dvec3(1, 0, 0)), 0.0)
      << "only an end is seen";
}

TEST(ContourIrradiance16, EqualsTheScalarForm) {
  Rng rng(3);
  const std::array<dvec3, 5> outline = {dvec3(0, 0, 1), dvec3(-0.2, 1, 1), dvec3(0.5, 1.3, 1),
                                        dvec3(1.2, 0.9, 1), dvec3(1, 0, 1)};
  int compared = 0;
  for (int trial = 0; trial < 500; ++trial) {
    alignas(64) std::array<float, 16> x, y, z, nx, ny, nz;
    for (std::size_t i = 0; i < 16; ++i) {
      const vec3 n = uniformSphere(rng.uniform(), rng.uniform());
      x[i] = 6 * rng.uniform() - 3;
      y[i] = 6 * rng.uniform() - 3;
      z[i] = 1 - 3 * rng.uniform();
      nx[i] = n.x;
      ny[i] = n.y;
      nz[i] = n.z;
    }
    const MaskReceivers r{x.data(), y.data(), z.data(), nx.data(), ny.data(), nz.data()};
    std::array<double, 16> value;
    std::uint32_t clipped = 0;
    contourIrradiance16(outline, r, value.data(), clipped);
    for (std::size_t i = 0; i < 16; ++i) {
      if ((clipped >> i & 1U) != 0U) continue;
      ++compared;
      const double scalar =
          polygonIrradiance(outline, dvec3(x[i], y[i], z[i]), dvec3(nx[i], ny[i], nz[i]));
      EXPECT_NEAR(value[i], scalar, 200 * kEps);
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(DiskIrradiance16, EqualsTheScalarForm) {
  Rng rng(4);
  const dvec3 center(0.2, 0.1, 1.0);
  const dvec3 axis = glm::normalize(dvec3(0.1, -0.2, -1.0));
  int above = 0;
  int cut = 0;
  for (int trial = 0; trial < 500; ++trial) {
    alignas(64) std::array<float, 16> x, y, z, nx, ny, nz;
    const float spread = trial % 2 == 0 ? 6.0F : 1.0F;
    for (std::size_t i = 0; i < 16; ++i) {
      const vec3 n = uniformSphere(rng.uniform(), rng.uniform());
      x[i] = spread * (rng.uniform() - 0.5F);
      y[i] = spread * (rng.uniform() - 0.5F);
      z[i] = 1.1F - 0.5F * spread * rng.uniform();
      nx[i] = n.x;
      ny[i] = n.y;
      nz[i] = n.z;
    }
    const MaskReceivers r{x.data(), y.data(), z.data(), nx.data(), ny.data(), nz.data()};
    std::array<double, 16> value;
    std::uint32_t clipped = 0;
    diskIrradiance16(center, axis, 0.3, r, value.data(), clipped);
    for (std::size_t i = 0; i < 16; ++i) {
      if ((clipped >> i & 1U) != 0U) {
        ++cut;
        continue;
      }
      const double scalar =
          diskIrradiance(center, axis, 0.3, dvec3(x[i], y[i], z[i]), dvec3(nx[i], ny[i], nz[i]));
      if (scalar > 0.0) ++above;
      EXPECT_NEAR(value[i], scalar, 200 * kEps);
    }
  }
  EXPECT_GT(above, 1500);
  EXPECT_GT(cut, 100);
}

}  // namespace
}  // namespace soffit::light
