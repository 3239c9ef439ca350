// SPDX-License-Identifier: MIT
#include "core/sh/polygon_light.h"

#include "core/math/quadrature.h"
#include "core/sh/basis.h"
#include "core/sh/polygon_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::sh {
namespace {

constexpr int kMaxNodes = 20;
constexpr double kLongestArc = kPi / 3.0;

const QuadratureRule& ruleOf(int nodes) {
  static const std::array<QuadratureRule, kMaxNodes> rules = [] {
    std::array<QuadratureRule, kMaxNodes> made;
    for (std::size_t n = 0; n < made.size(); ++n) made[n] = gaussLegendre(static_cast<int>(n) + 1);
    return made;
  }();
  return rules[static_cast<std::size_t>(nodes - 1)];
}

/// Nodes for a trigonometric polynomial of degree `bands` over `angle`: the remainder of the rule
/// with k nodes is about (e phase / 4k)^2k, phase = degree angle / 2; 1e-12 is wanted.
int nodesFor(double angle, int bands) {
  const double phase = std::max(1e-3, 0.5 * bands * angle);
  int k = 2;
  while (k < kMaxNodes && 2.0 * k * std::log(4.0 * k / (2.718281828 * phase)) < 27.6) ++k;
  return k;
}

/// Calls visit(t, weight) so that sum weight f(t) is the integral of f along the arc.
template <class Visit>
void alongArc(const Arc& arc, int bands, const Visit& visit) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(arc.angle / kLongestArc)));
  const double half = 0.5 * arc.angle / pieces;
  const QuadratureRule& rule = ruleOf(nodesFor(2.0 * half, bands));
  for (int piece = 0; piece < pieces; ++piece) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      visit(half * (2.0 * piece + 1.0 + rule.nodes[i]), half * rule.weights[i]);
    }
  }
}

/// Adds the boundary sums of l >= 1, not yet divided by l (l + 1).
void addBoundary(const std::vector<Arc>& arcs, int bands, Coefficients& sum) {
  std::array<double, kMaxCoefficients> slope;
  for (const Arc& arc : arcs) {
    alongArc(arc, bands, [&](double t, double weight) {
      evaluateDerivative(arc.at(t), arc.inward, bands, slope);
      for (std::size_t i = 1; i < sum.size(); ++i) sum[i] += weight * slope[i];
    });
  }
}

void finish(double solid_angle, int bands, Coefficients& sum) {
  sum[0] = solid_angle / std::sqrt(4.0 * kPi);
  for (int l = 1; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) sum[index(l, m)] /= l * (l + 1.0);
  }
}

}  // namespace

double polygonSolidAngle(std::span<const dvec3> outline, const dvec3& p) {
  if (outline.size() < 3) return 0.0;
  double sum = 0.0;
  const dvec3 a = outline[0] - p;
  const double la = glm::length(a);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const dvec3 b = outline[i] - p;
    const dvec3 c = outline[i + 1] - p;
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    const double numerator = glm::dot(a, glm::cross(b, c));
    const double denominator =
        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    if (numerator != 0.0) sum -= 2.0 * std::atan2(numerator, denominator);
  }
  return sum;
}

Coefficients polygonCoefficients(std::span<const dvec3> outline, const dvec3& p, int bands) {
  Coefficients sum(coefficientCount(bands), 0.0);
  const double solid_angle = polygonSolidAngle(outline, p);
  if (!(solid_angle > 0.0)) return sum;
  addBoundary(arcsOf(outline, p), bands, sum);
  finish(solid_angle, bands, sum);
  return sum;
}

Coefficients CoefficientsWithGradient::at(const dvec3& offset) const {
  Coefficients moved = values;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += glm::dot(gradients[i], offset);
  return moved;
}

CoefficientsWithGradient polygonCoefficientsWithGradient(std::span<const dvec3> outline,
                                                         const dvec3& p, int bands) {
  CoefficientsWithGradient result{Coefficients(coefficientCount(bands), 0.0),
                                  std::vector<dvec3>(coefficientCount(bands), dvec3(0.0))};
  const double solid_angle = polygonSolidAngle(outline, p);
  if (!(solid_angle > 0.0)) return result;
  const std::vector<Arc> arcs = arcsOf(outline, p);
  addBoundary(arcs, bands, result.values);
  finish(solid_angle, bands, result.values);
  std::array<double, kMaxCoefficients> basis;
  for (const Arc& arc : arcs) {
    // One band more: 1 / R is itself a sine along the edge.
    alongArc(arc, bands + 1, [&](double t, double weight) {
      evaluate(arc.at(t), bands, basis);
      const dvec3 move = weight * arc.inverseDistance(t) * arc.inward;
      for (std::size_t i = 0; i < result.gradients.size(); ++i) {
        result.gradients[i] += basis[i] * move;
      }
    });
  }
  return result;
}

}  // namespace soffit::sh
