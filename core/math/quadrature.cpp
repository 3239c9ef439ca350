// SPDX-License-Identifier: MIT
#include "core/math/quadrature.h"

#include "core/math/vec.h"

#include <cassert>
#include <cmath>

namespace soffit {
namespace {

/// P_n and its derivative at t in (-1, 1).
struct LegendreValue {
  double value, slope;
};

LegendreValue legendre(int n, double t) {
  double before = 1.0;
  double p = t;
  for (int l = 2; l <= n; ++l) {
    const double next = ((2.0 * l - 1.0) * t * p - (l - 1.0) * before) / l;
    before = p;
    p = next;
  }
  return {p, n * (t * p - before) / (t * t - 1.0)};
}

}  // namespace

QuadratureRule gaussLegendre(int n) {
  assert(n >= 1);
  const auto count = static_cast<std::size_t>(n);
  QuadratureRule rule{std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t i = 0; i < (count + 1) / 2; ++i) {
    double t = std::cos(kPi * (static_cast<double>(i) + 0.75) / (n + 0.5));
    for (int step = 0; step < 100; ++step) {
      const LegendreValue p = legendre(n, t);
      const double move = p.value / p.slope;
      t -= move;
      if (std::abs(move) < 1e-15) break;
    }
    if (2 * i + 1 == count) t = 0.0;  // the middle one
    const double slope = legendre(n, t).slope;
    rule.nodes[i] = -t;
    rule.nodes[count - 1 - i] = t;
    rule.weights[i] = rule.weights[count - 1 - i] = 2.0 / ((1.0 - t * t) * slope * slope);
  }
  return rule;
}

QuadratureRule gaussLegendre(int n, double a, double b) {
  QuadratureRule rule = gaussLegendre(n);
  for (double& t : rule.nodes) t = 0.5 * ((b - a) * t + a + b);
  for (double& w : rule.weights) w *= 0.5 * (b - a);
  return rule;
}

}  // namespace soffit
