// SPDX-License-Identifier: MIT
#include "core/photometry/goniometer.h"

#include "tests/core/photometry/distributions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace soffit::photometry {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

std::vector<double> knots(double first, double last, int count) {
  std::vector<double> k;
  for (int i = 0; i < count; ++i) k.push_back(first + (last - first) * i / (count - 1));
  return k;
}

/// Table of I(V, H), radians.
GonioTable table(GonioType type, std::vector<double> v, std::vector<double> h,
                 const std::function<double(double, double)>& candela, bool mirrored = false) {
  GonioTable t{type, std::move(v), std::move(h), {}, mirrored};
  for (const double ih : t.horizontal_deg) {
    for (const double iv : t.vertical_deg) t.candela.push_back(candela(radians(iv), radians(ih)));
  }
  return t;
}

double ones(double, double) {
  return 1.0;
}

TEST(Goniometer, AUniformHemisphereHasTwoPiLumens) {
  const auto quarter = knots(-90, 90, 5);
  for (const GonioType type : {GonioType::a, GonioType::b}) {
    EXPECT_NEAR(gonioFlux(table(type, quarter, quarter, ones)), 2 * kPi, 1000 * kEps);
    EXPECT_NEAR(gonioFlux(table(type, quarter, knots(0, 90, 3), ones, true)), 2 * kPi, 1000 * kEps);
  }
}

TEST(Goniometer, TheCosineLiesOnTheLatitude) {
  // A strip V in 60..90, H in -90..90: type A ∫cos V dV · π, type B ∫cos H dH · π/6.
  const auto strip = knots(60, 90, 2);
  const auto wide = knots(-90, 90, 3);
  EXPECT_NEAR(gonioFlux(table(GonioType::a, strip, wide, ones)), (1.0 - std::sqrt(3.0) / 2.0) * kPi,
              1000 * kEps);
  EXPECT_NEAR(gonioFlux(table(GonioType::b, strip, wide, ones)), 2.0 * kPi / 6.0, 1000 * kEps);
}

TEST(Goniometer, KnotsThatNearlyCoincideDoNoHarm) {
  const GonioTable t{GonioType::b, {-90, 90}, {-90, 0, 1e-320, 90}, {1, 1, 1, 1, 9, 9, 9, 9}};
  // One hemisphere: π at 1 cd on one side, π at 9 cd on the other.
  EXPECT_NEAR(gonioFlux(t), kPi * 10.0, 1e4 * kEps);
}

TEST(Goniometer, PlusVLeansToC0AndPlusHToC90) {
  for (const GonioType type : {GonioType::a, GonioType::b}) {
    const auto t = table(type, knots(-90, 90, 181), knots(-90, 90, 181),
                         [](double v, double h) { return 1000.0 + 100.0 * v + 10.0 * h; });
    // Exact at knots up to the rounding of asin, which near ±1 loses half the digits.
    constexpr double kPoleRoundoff = 1e-5;
    EXPECT_NEAR(gonioIntensity(t, {0, 0, -1}), 1000.0, kPoleRoundoff);
    EXPECT_NEAR(gonioIntensity(t, toward(0, 40)), 1000.0 + 100.0 * radians(40), kPoleRoundoff);
    EXPECT_NEAR(gonioIntensity(t, toward(180, 40)), 1000.0 - 100.0 * radians(40), kPoleRoundoff);
    EXPECT_NEAR(gonioIntensity(t, toward(90, 40)), 1000.0 + 10.0 * radians(40), kPoleRoundoff);
    EXPECT_NEAR(gonioIntensity(t, toward(270, 40)), 1000.0 - 10.0 * radians(40), kPoleRoundoff);
  }
}

TEST(Goniometer, TypesAAndBDifferOffThePrincipalPlanes) {
  // At V = H = 45: A is (sin 45, cos² 45, cos² 45), B (cos 45 sin 45, sin 45, ..).
  const auto peaked = [](double v, double h) {
    return std::max(0.0, 1.0 - std::abs(v - kPi / 4) - std::abs(h - kPi / 4));
  };
  const auto a = table(GonioType::a, knots(-90, 90, 181), knots(-90, 90, 181), peaked);
  const auto b = table(GonioType::b, knots(-90, 90, 181), knots(-90, 90, 181), peaked);
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(gonioIntensity(a, {s, 0.5, -0.5}), 1.0, 1000 * kEps);
  EXPECT_NEAR(gonioIntensity(b, {0.5, s, -0.5}), 1.0, 1000 * kEps);
  EXPECT_LT(gonioIntensity(a, {0.5, s, -0.5}), 0.9);
}

TEST(Goniometer, CGammaKeepsTheLumensAndTheDirections) {
  const auto spot = [](double v, double h) { return 5000.0 * std::exp(-20 * (v * v + 2 * h * h)); };
  for (const GonioType type : {GonioType::a, GonioType::b}) {
    const auto t = table(type, knots(-60, 60, 61), knots(0, 60, 31), spot, true);
    const auto d = toCGamma(t);
    EXPECT_NEAR(d.flux() / gonioFlux(t), 1.0, 1e4 * kEps);  // scaled: rounding only
    EXPECT_EQ(d.gamma_deg.back(), 90.0);
    // Truncation: the scale absorbs some 1e-4, interpolation on half the step is below 1e-3.
    for (const double c : {0.0, 37.0, 90.0, 200.0, 300.0}) {
      for (const double gamma : {0.0, 7.3, 21.0, 40.0}) {
        const dvec3 w = toward(c, gamma);
        EXPECT_NEAR(d.intensity(w), gonioIntensity(t, w), 2e-3 * 5000.0) << c << ' ' << gamma;
      }
    }
  }
}

TEST(Goniometer, BeyondTheHorizonGammaGoesTo180) {
  const auto t = table(GonioType::a, knots(-90, 90, 19), knots(-180, 180, 37), ones);
  const auto d = toCGamma(t);
  EXPECT_EQ(d.gamma_deg.back(), 180.0);
  EXPECT_NEAR(d.flux(), 4.0 * kPi, 1e4 * kEps);
  EXPECT_NEAR(d.intensity({0, 0, 1}), 1.0, 1e4 * kEps);
}

TEST(Goniometer, OutsideTheTableItIsDark) {
  const auto t = table(GonioType::b, knots(-30, 30, 7), knots(-20, 20, 5), ones);
  EXPECT_EQ(gonioIntensity(t, toward(0, 30.1)), 0.0);
  EXPECT_EQ(gonioIntensity(t, toward(90, 20.1)), 0.0);
  EXPECT_EQ(gonioIntensity(t, {0, 0, 1}), 0.0);
}

}  // namespace
}  // namespace soffit::photometry
