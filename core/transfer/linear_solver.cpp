// SPDX-License-Identifier: MIT
#include "core/transfer/linear_solver.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace soffit::transfer {
namespace {

using Lanes = glm::dvec4;

Lanes inner(std::span<const vec4> a, std::span<const vec4> b) {
  Lanes sum(0.0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += Lanes(a[i] * b[i]);
  return sum;
}

/// a / b, 0 for lanes that have nothing left to do.
Lanes ratio(const Lanes& a, const Lanes& b) {
  constexpr double kLeast = std::numeric_limits<double>::min();
  Lanes q(0.0);
  for (int c = 0; c < 4; ++c) {
    if (std::abs(b[c]) > kLeast) q[c] = a[c] / b[c];
  }
  return q;
}

}  // namespace

int solveLanes(const LaneProduct& product, std::span<const vec4> g, std::span<vec4> x,
               double tolerance, int most) {
  const std::size_t n = g.size();
  std::vector<vec4> work(6 * n, vec4(0.0F));
  const auto part = [&](std::size_t k) { return std::span(work).subspan(k * n, n); };
  const std::span<vec4> r = part(0), shadow = part(1), p = part(2), v = part(3), s = part(4),
                        t = part(5);
  const auto apply = [&](std::span<const vec4> from, std::span<vec4> to) {
    product(from, to);
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i] - to[i];
  };
  // The first two terms of the series are a good start: r = g - (I - K) g = K g.
  std::copy(g.begin(), g.end(), x.begin());
  product(g, r);
  std::copy(r.begin(), r.end(), shadow.begin());
  const Lanes goal = tolerance * tolerance * inner(g, g);
  Lanes rho(1.0), alpha(1.0), omega(1.0);
  for (int k = 0; k < most; ++k) {
    // Lanes that are done rest: what is left of them is rounding, and steps along it lead astray.
    const glm::bvec4 todo = glm::greaterThan(inner(r, r), goal);
    if (!glm::any(todo)) return 2 * k + 1;
    const Lanes rho_before = rho;
    rho = inner(shadow, r);
    const vec4 beta(ratio(rho, rho_before) * ratio(alpha, omega));
    const vec4 back(omega);
    for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + beta * (p[i] - back * v[i]);
    apply(p, v);
    alpha = Lanes(todo) * ratio(rho, inner(shadow, v));
    const vec4 along_p(alpha);
    for (std::size_t i = 0; i < n; ++i) s[i] = r[i] - along_p * v[i];
    apply(s, t);
    omega = Lanes(todo) * ratio(inner(t, s), inner(t, t));
    const vec4 along_s(omega);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += along_p * p[i] + along_s * s[i];
      r[i] = s[i] - along_s * t[i];
    }
  }
  return 2 * most + 1;
}

}  // namespace soffit::transfer
