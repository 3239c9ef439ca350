// SPDX-License-Identifier: MIT
#include "core/sh/basis.h"

#include "core/sh/polynomials.h"
#include "core/sh/recurrence.h"

#include <cmath>

namespace soffit::sh {
namespace {

template <class Real>
Recurrence<Real> makeRecurrence() {
  Recurrence<Real> r;
  double q = std::sqrt(1.0 / (4.0 * kPi));
  for (int m = 0; m < kMaxBands; ++m) {
    if (m > 0) q *= std::sqrt((2.0 * m + 1.0) / (2.0 * m));
    const auto row = static_cast<std::size_t>(m);
    r.start[row] = static_cast<Real>(m > 0 ? std::sqrt(2.0) * q : q);
    for (int l = m + 1; l < kMaxBands; ++l) {
      const double below = double(l) * l - double(m) * m;
      const double before = (l - 1.0) * (l - 1.0) - double(m) * m;
      RecurrenceStep<Real>& step = r.step[row][static_cast<std::size_t>(l)];
      step.a = static_cast<Real>(std::sqrt((4.0 * l * l - 1.0) / below));
      if (l == m + 1) continue;
      step.b = static_cast<Real>(-std::sqrt(before * (2.0 * l + 1.0) / ((2.0 * l - 3.0) * below)));
    }
  }
  return r;
}

template <class Vector, class Real = typename Vector::value_type>
void recur(const Vector& d, int bands, std::span<Real> values) {
  assert(bands >= 1 && bands <= kMaxBands && values.size() >= coefficientCount(bands));
  const Recurrence<Real>& r = recurrence<Real>();
  Real c = 1;
  Real s = 0;
  for (int m = 0; m < bands; ++m) {
    const auto& steps = r.step[static_cast<std::size_t>(m)];
    Real before = 0;
    Real q = r.start[static_cast<std::size_t>(m)];
    for (int l = m; l < bands; ++l) {
      if (l > m) {
        const RecurrenceStep<Real>& step = steps[static_cast<std::size_t>(l)];
        const Real next = step.a * d.z * q + step.b * before;
        before = q;
        q = next;
      }
      values[index(l, m)] = q * c;
      if (m > 0) values[index(l, -m)] = q * s;
    }
    const Real next_c = c * d.x - s * d.y;
    s = s * d.x + c * d.y;
    c = next_c;
  }
}

template <class Vector, class Real = typename Vector::value_type>
void unrolledOrRecur(const Vector& d, int bands, std::span<Real> values) {
  assert(values.size() >= coefficientCount(bands));
  Real* out = values.data();
  switch (bands) {
    case 1:
      return polynomials<1>(d.x, d.y, d.z, out);
    case 2:
      return polynomials<2>(d.x, d.y, d.z, out);
    case 3:
      return polynomials<3>(d.x, d.y, d.z, out);
    case 4:
      return polynomials<4>(d.x, d.y, d.z, out);
    case 5:
      return polynomials<5>(d.x, d.y, d.z, out);
    default:
      return recur(d, bands, values);
  }
}

/// What y_{l,m} and y_{l,-m} and their derivatives are made of.
struct Term {
  double q, slope;            // Q_lm(z) and dQ/dz
  double c, s;                // (x + iy)^m
  double c_before, s_before;  // (x + iy)^(m-1)
};

/// Calls visit(l, m, term) for all 0 <= m <= l < bands.
template <class Visit>
void walk(const dvec3& d, int bands, const Visit& visit) {
  assert(bands >= 1 && bands <= kMaxBands);
  const Recurrence<double>& r = recurrence<double>();
  double c = 1.0, s = 0.0, c_before = 0.0, s_before = 0.0;
  for (int m = 0; m < bands; ++m) {
    const auto& steps = r.step[static_cast<std::size_t>(m)];
    double q = r.start[static_cast<std::size_t>(m)], q_before = 0.0;
    double slope = 0.0, slope_before = 0.0;
    for (int l = m; l < bands; ++l) {
      if (l > m) {
        const RecurrenceStep<double>& step = steps[static_cast<std::size_t>(l)];
        const double next_slope = step.a * (q + d.z * slope) + step.b * slope_before;
        const double next = step.a * d.z * q + step.b * q_before;
        slope_before = slope;
        slope = next_slope;
        q_before = q;
        q = next;
      }
      visit(l, m, Term{q, slope, c, s, c_before, s_before});
    }
    c_before = c;
    s_before = s;
    c = c_before * d.x - s_before * d.y;
    s = s_before * d.x + c_before * d.y;
  }
}

}  // namespace

template <class Real>
const Recurrence<Real>& recurrence() {
  static const Recurrence<Real> made = makeRecurrence<Real>();
  return made;
}
template const Recurrence<float>& recurrence<float>();
template const Recurrence<double>& recurrence<double>();

void evaluate(const dvec3& direction, int bands, std::span<double> values) {
  unrolledOrRecur(direction, bands, values);
}

void evaluate(const vec3& direction, int bands, std::span<float> values) {
  unrolledOrRecur(direction, bands, values);
}

void evaluateByRecurrence(const dvec3& direction, int bands, std::span<double> values) {
  recur(direction, bands, values);
}

void evaluateByRecurrence(const vec3& direction, int bands, std::span<float> values) {
  recur(direction, bands, values);
}

void evaluateWithGradient(const dvec3& direction, int bands, std::span<double> values,
                          std::span<dvec3> gradients) {
  assert(gradients.size() >= coefficientCount(bands));
  walk(direction, bands, [&](int l, int m, const Term& t) {
    values[index(l, m)] = t.q * t.c;
    gradients[index(l, m)] = dvec3(t.q * m * t.c_before, -t.q * m * t.s_before, t.slope * t.c);
    if (m == 0) return;
    values[index(l, -m)] = t.q * t.s;
    gradients[index(l, -m)] = dvec3(t.q * m * t.s_before, t.q * m * t.c_before, t.slope * t.s);
  });
}

void evaluateDerivative(const dvec3& direction, const dvec3& along, int bands,
                        std::span<double> derivatives) {
  assert(derivatives.size() >= coefficientCount(bands));
  walk(direction, bands, [&](int l, int m, const Term& t) {
    const double slope = t.slope * along.z;
    const double qm = t.q * m;
    derivatives[index(l, m)] = slope * t.c + qm * (t.c_before * along.x - t.s_before * along.y);
    if (m == 0) return;
    derivatives[index(l, -m)] = slope * t.s + qm * (t.s_before * along.x + t.c_before * along.y);
  });
}

double reconstruct(std::span<const double> coefficients, const dvec3& direction) {
  std::array<double, kMaxCoefficients> values;
  evaluate(direction, bandsOf(coefficients.size()), values);
  double sum = 0.0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) sum += coefficients[i] * values[i];
  return sum;
}

}  // namespace soffit::sh
