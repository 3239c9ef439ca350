// SPDX-License-Identifier: MIT
#include "core/sh/polygon_light.h"

#include "core/math/quadrature.h"
#include "core/sh/basis.h"
#include "core/sh/convolution.h"
#include "tests/core/sh/random_directions.h"

#include <gtest/gtest.h>

#include <array>

namespace soffit::sh {
namespace {

using Outline = std::vector<dvec3>;

/// A panel that emits down: counter-clockwise seen from below.
Outline panel(double w, double h, double z) {
  return {{-w / 2, -h / 2, z}, {-w / 2, h / 2, z}, {w / 2, h / 2, z}, {w / 2, -h / 2, z}};
}

/// integral of y over triangle abc seen from p: surface quadrature cos / r^2 over squares of the
/// triangle, n x n pieces with 8 x 8 nodes.
void addTriangle(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& p, int bands, int n,
                 Coefficients& sum) {
  const QuadratureRule rule = gaussLegendre(8, 0.0, 1.0);
  const dvec3 normal = glm::cross(b - a, c - a);
  std::array<double, kMaxCoefficients> y;
  for (int piece = 0; piece < n * n; ++piece) {
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        const double s = (piece / n + rule.nodes[i]) / n, t = (piece % n + rule.nodes[j]) / n;
        const dvec3 to = a + s * ((1.0 - t) * (b - a) + t * (c - a)) - p;  // Duffy's square
        const double r2 = glm::dot(to, to), r = std::sqrt(r2);
        const double angle = std::abs(glm::dot(normal, to)) / (r2 * r) * s;
        evaluate(to / r, bands, y);
        const double weight = rule.weights[i] * rule.weights[j] / (n * n) * angle;
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * y[k];
      }
    }
  }
}

Coefficients bySurface(const Outline& o, const std::vector<std::array<std::size_t, 3>>& triangles,
                       const dvec3& p, int bands, int n) {
  Coefficients sum(coefficientCount(bands), 0.0);
  for (const auto& t : triangles) addTriangle(o[t[0]], o[t[1]], o[t[2]], p, bands, n, sum);
  return sum;
}

const std::vector<std::array<std::size_t, 3>> kQuad{{0, 1, 2}, {0, 2, 3}};

TEST(PolygonSolidAngle, OfACubeFaceIsASixthOfTheSphere) {
  EXPECT_NEAR(polygonSolidAngle(panel(2, 2, 1), dvec3(0)), 4.0 * kPi / 6.0, 16 * kEps);
  EXPECT_NEAR(polygonSolidAngle(panel(2, 2, 1), dvec3(0, 0, 2)), -4.0 * kPi / 6.0, 16 * kEps);
  EXPECT_EQ(polygonSolidAngle(panel(2, 2, 1), dvec3(5, 0, 1)), 0.0);
  // Close to a large panel: nearly the hemisphere, where the denominator is negative.
  EXPECT_NEAR(polygonSolidAngle(panel(2e3, 2e3, 1), dvec3(0)), 2.0 * kPi, 6e-3);
}

TEST(PolygonLight, MatchesSurfaceQuadratureAtTenBands) {
  Rng rng(91);
  for (const auto& [outline, distance] : {std::pair{panel(1.2, 0.6, 0.0), 2.0},
                                          {panel(3, 2, 0.0), 0.5},
                                          {panel(0.6, 0.6, 0.0), 20.0}}) {
    for (int i = 0; i < 4; ++i) {
      const dvec3 p(rng.uniformDouble() - 0.5, 2.0 * rng.uniformDouble() - 1.0, -distance);
      const Coefficients exact = bySurface(outline, kQuad, p, kMaxBands, distance < 1.0 ? 16 : 4);
      const double scale = largest(exact);
      EXPECT_LE(largestDifference(polygonCoefficients(outline, p, kMaxBands), exact),
                1e-11 * scale);
      EXPECT_LE(largestDifference(polygonCoefficientsClosedForm(outline, p, kMaxBands), exact),
                1e-11 * scale);
    }
  }
}

TEST(PolygonLight, MatchesAMillionSamples) {
  const Outline outline = panel(1.2, 0.6, 1.5);
  const dvec3 p(0.7, -0.2, 0.0);
  const Coefficients exact = polygonCoefficients(outline, p, 5);
  // One sample in each of 1000 x 1000 cells: the standard error is that of a plain million,
  // W sd(y) / 1000 ~ 1e-3 of the largest coefficient, times the variation within a cell, 1e-3.
  Rng rng(92);
  Coefficients sum(25, 0.0);
  std::array<double, 25> y;
  constexpr int kSide = 1000;
  constexpr int kSamples = kSide * kSide;
  for (int k = 0; k < kSamples; ++k) {
    const double u = (k / kSide + rng.uniformDouble()) / kSide;
    const double v = (k % kSide + rng.uniformDouble()) / kSide;
    const dvec3 to = outline[0] + u * (outline[3] - outline[0]) + v * (outline[1] - outline[0]) - p;
    const double r2 = glm::dot(to, to);
    evaluate(to / std::sqrt(r2), 5, y);
    const double weight = 0.72 * to.z / (r2 * std::sqrt(r2)) / kSamples;
    for (std::size_t i = 0; i < 25; ++i) sum[i] += weight * y[i];
  }
  EXPECT_LE(largestDifference(sum, exact), 1e-5 * largest(exact));
}

TEST(PolygonLight, ClosedFormEqualsBoundaryQuadratureForRandomPolygons) {
  Rng rng(93);
  for (int i = 0; i < 200; ++i) {
    // A star-shaped, mostly non-convex outline in a random plane.
    const dvec3 n = randomDirection(rng);
    const dvec3 e = glm::normalize(glm::cross(n, randomDirection(rng)));
    const dvec3 f = glm::cross(n, e);
    const int corners = 3 + static_cast<int>(rng.below(8));
    const dvec3 center = 3.0 * randomDirection(rng);
    Outline outline;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * kPi * k / corners, r = 0.2 + 2.0 * rng.uniformDouble();
      outline.push_back(center + r * (std::cos(angle) * e + std::sin(angle) * f));
    }
    // Counter-clockwise about n: emits towards n.
    const double height = glm::dot(-center, n);
    const Coefficients a = polygonCoefficients(outline, dvec3(0), kMaxBands);
    const Coefficients b = polygonCoefficientsClosedForm(outline, dvec3(0), kMaxBands);
    EXPECT_EQ(largest(a) > 0.0, height > 0.0);
    // Star-shaped about a centre that may be seen under a grazing angle: relative to the sphere.
    EXPECT_LE(largestDifference(a, b), 1e-10) << i;
  }
}

TEST(PolygonLight, NonConvexOutlinesAreTheSumOfTheirParts) {
  const Outline whole{{0, 0, 1}, {0, 2, 1}, {1, 2, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1}};  // an L
  const Outline low{{0, 0, 1}, {0, 1, 1}, {2, 1, 1}, {2, 0, 1}};
  const Outline high{{0, 1, 1}, {0, 2, 1}, {1, 2, 1}, {1, 1, 1}};
  for (const dvec3& p : {dvec3(0.5, 0.5, 0), dvec3(1.7, 1.7, 0.3), dvec3(-3, 1, -2)}) {
    Coefficients sum = polygonCoefficients(low, p, 8);
    const Coefficients rest = polygonCoefficients(high, p, 8);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += rest[i];
    EXPECT_LE(largestDifference(polygonCoefficients(whole, p, 8), sum), 1e-11);
    EXPECT_LE(largestDifference(polygonCoefficientsClosedForm(whole, p, 8), sum), 1e-11);
  }
}

TEST(PolygonLight, BoxAroundTheReceiverIsUniformLight) {
  Coefficients sum(kMaxCoefficients, 0.0);
  const Outline ceiling = panel(2, 2, 1);
  Rng rng(94);
  const dvec3 p(0.3, -0.6, 0.1);
  std::vector<dmat3> faces{dmat3(1.0)};
  for (const double angle : {kPi / 2, kPi, -kPi / 2})
    faces.push_back(turnAbout(dvec3(1, 0, 0), angle));
  for (const double angle : {kPi / 2, -kPi / 2}) faces.push_back(turnAbout(dvec3(0, 1, 0), angle));
  for (const dmat3& face : faces) {
    Outline outline;
    for (const dvec3& v : ceiling) outline.push_back(face * v);
    const Coefficients part = polygonCoefficients(outline, p, kMaxBands);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
  }
  EXPECT_NEAR(sum[0], 2.0 * std::sqrt(kPi), 1e-13);
  EXPECT_LE(largest(std::span(sum).subspan(1)), 1e-11);
}

// Above the horizon the clamped cosine of 10 bands is within its truncation of Lambert's formula.
TEST(PolygonLight, IrradianceIsLambertsWithinTheBands) {
  const Coefficients c = polygonCoefficients(panel(1.2, 0.6, 2.0), dvec3(0), kMaxBands);
  // Four equal quarters over their corner, Howell C-11.
  const double x = 0.3, y = 0.15, a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
  const double lambert = 4.0 * 0.5 * (x / a * std::atan(y / a) + y / b * std::atan(x / b));
  EXPECT_NEAR(irradiance(c, dvec3(0, 0, 1)), lambert, 0.02 * lambert);
}

TEST(PolygonLight, DegenerateInputGivesNothingOrWhatIsLeft) {
  const Outline good = panel(1, 1, 1);
  const Coefficients exact = polygonCoefficients(good, dvec3(0), 5);
  const auto nothing = [](const Outline& o, const dvec3& p) {
    return largest(polygonCoefficients(o, p, 5)) == 0.0 &&
           largest(polygonCoefficientsClosedForm(o, p, 5)) == 0.0 &&
           largest(polygonCoefficientsWithGradient(o, p, 5).values) == 0.0;
  };
  EXPECT_TRUE(nothing({}, dvec3(0)));
  EXPECT_TRUE(nothing({good[0], good[1]}, dvec3(0)));
  EXPECT_TRUE(nothing({good[0], good[1], good[0]}, dvec3(0)));
  EXPECT_TRUE(nothing({{0, 0, 1}, {0.25, 0, 1}, {0.75, 0, 1}}, dvec3(0, 0.5, 0)));  // no area
  EXPECT_TRUE(nothing(good, dvec3(0, 0, 2)));                                       // behind
  EXPECT_TRUE(nothing(good, dvec3(4, 4, 1)));                                       // in its plane
  EXPECT_TRUE(nothing(good, good[0]));                                              // on a corner
  const Outline repeated{good[0], good[0], good[1], good[2], good[2], good[3], good[0]};
  EXPECT_LE(largestDifference(polygonCoefficients(repeated, dvec3(0), 5), exact), 1e-14);
  EXPECT_LE(largestDifference(polygonCoefficientsClosedForm(repeated, dvec3(0), 5), exact), 1e-13);
  const Outline halved{good[0], 0.5 * (good[0] + good[1]), good[1], good[2], good[3]};
  EXPECT_LE(largestDifference(polygonCoefficients(halved, dvec3(0), 5), exact), 1e-13);
}

TEST(PolygonLight, FarAwayItIsADelta) {
  const dvec3 p(300, -200, -1000);
  const Outline outline = panel(0.6, 0.6, 0);
  const Coefficients c = polygonCoefficients(outline, p, kMaxBands);
  const double r = glm::length(p);
  std::array<double, kMaxCoefficients> y;
  evaluate(-p / r, kMaxBands, y);
  const double solid_angle = 0.36 * 1000.0 / (r * r * r);
  for (std::size_t i = 0; i < y.size(); ++i) {
    EXPECT_NEAR(c[i] / solid_angle, y[i], 1e-5);  // l^2 (size / distance)^2
  }
}

TEST(PolygonLight, GradientsAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  Rng rng(95);
  for (const auto& [outline, distance] :
       {std::pair{panel(1.2, 0.6, 0.0), 2.0},
        {panel(3, 2, 0.0), 0.5},
        {Outline{{0, 0, 0}, {0, 2, 0}, {1, 2, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}}, 1.0}}) {
    const dvec3 p(rng.uniformDouble(), rng.uniformDouble(), -distance);
    const CoefficientsWithGradient at = polygonCoefficientsWithGradient(outline, p, kMaxBands);
    EXPECT_EQ(at.values, polygonCoefficients(outline, p, kMaxBands));
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0.0);
      step[axis] = kStep;
      const Coefficients low = polygonCoefficients(outline, p - step, kMaxBands);
      const Coefficients high = polygonCoefficients(outline, p + step, kMaxBands);
      for (std::size_t i = 0; i < low.size(); ++i) {
        const double difference = (high[i] - low[i]) / (2.0 * kStep);
        // h^2 / 6 times a third derivative of at most (l / distance)^3 W, and eps / h.
        EXPECT_NEAR(at.gradients[i][axis], difference, 2e-7) << i;
      }
    }
    // The estimate's error falls with the square of the way.
    const dvec3 way(0.02, -0.01, 0.015);
    const double whole =
        largestDifference(at.at(way), polygonCoefficients(outline, p + way, kMaxBands));
    const double half =
        largestDifference(at.at(0.5 * way), polygonCoefficients(outline, p + 0.5 * way, kMaxBands));
    EXPECT_NEAR(half / whole, 0.25, 0.06);
  }
}

}  // namespace
}  // namespace soffit::sh
