// SPDX-License-Identifier: MIT
#include "core/photometry/intensity_distribution.h"

#include "core/photometry/angle_lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace soffit::photometry {
namespace {

// A direction in the plane of the last gamma (the horizon of a downlight) must not fall out of
// the table by the rounding of a rotation.
constexpr double kEdgeDeg = 1e-9;

double lerp(double a, double b, double t) {
  return a + t * (b - a);
}

/// ∫ I(γ) sin γ dγ over one plane for I linear between the knots (radians inside):
/// per interval I₀ cos γ₀ - I₁ cos γ₁ + (I₁ - I₀)/(γ₁ - γ₀) (sin γ₁ - sin γ₀). The quotient of
/// sines is written as cos of the middle times sinc of half the step, which does not cancel.
double planeIntegral(std::span<const double> gamma_deg, std::span<const double> candela) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < gamma_deg.size(); ++i) {
    const double g0 = radians(gamma_deg[i]);
    const double g1 = radians(gamma_deg[i + 1]);
    const double half = (g1 - g0) / 2.0;
    const double mean_cosine =
        std::cos((g0 + g1) / 2.0) * (half > 0.0 ? std::sin(half) / half : 1.0);
    sum += candela[i] * std::cos(g0) - candela[i + 1] * std::cos(g1) +
           (candela[i + 1] - candela[i]) * mean_cosine;
  }
  return sum;
}

/// The two planes around an angle and the fraction between them; the last closes on the first.
struct PlanePair {
  std::size_t lower = 0;
  std::size_t upper = 0;
  double t = 0.0;
};

PlanePair planePair(std::span<const double> c_deg, double angle_deg) {
  const std::size_t last = c_deg.size() - 1;
  if (last == 0) return {};
  if (angle_deg >= c_deg[last]) {
    return {last, 0, (angle_deg - c_deg[last]) / (c_deg[0] + 360.0 - c_deg[last])};
  }
  const Bracket b = bracket(c_deg, angle_deg);
  return {b.index, b.index + 1, b.t};
}

}  // namespace

double IntensityDistribution::intensity(const dvec3& direction) const {
  const double across2 = direction.x * direction.x + direction.y * direction.y;
  const double gamma = degrees(std::atan2(std::sqrt(across2), -direction.z));
  if (c_deg.size() == 1) return intensityAt(0.0, gamma);
  return intensityAt(degrees(std::atan2(direction.y, direction.x)), gamma);
}

double IntensityDistribution::intensityAt(double angle_c_deg, double angle_gamma_deg) const {
  assert(candela.size() == c_deg.size() * gamma_deg.size());
  if (gamma_deg.size() < 2 || c_deg.empty()) return 0.0;
  // Written so that a NaN is outside as well.
  const bool inside = angle_gamma_deg >= gamma_deg.front() - kEdgeDeg &&
                      angle_gamma_deg <= gamma_deg.back() + kEdgeDeg;
  if (!inside) return 0.0;
  const Bracket g = bracket(gamma_deg, angle_gamma_deg);
  const auto along = [&](std::size_t plane) {
    const double* row = candela.data() + plane * gamma_deg.size() + g.index;
    return lerp(row[0], row[1], g.t);
  };
  if (c_deg.size() == 1) return along(0);
  double c =
      angle_c_deg >= 0.0 && angle_c_deg < 360.0 ? angle_c_deg : std::fmod(angle_c_deg, 360.0);
  if (c < 0.0) c += 360.0;
  const PlanePair planes = planePair(c_deg, c);
  return lerp(along(planes.lower), along(planes.upper), planes.t);
}

double IntensityDistribution::flux() const {
  assert(candela.size() == c_deg.size() * gamma_deg.size());
  const std::size_t planes = c_deg.size();
  double lumens = 0.0;
  for (std::size_t i = 0; i < planes; ++i) {
    // Trapezoid on the circle: a plane stands for half the gap on either side, all of it if alone.
    const double before = i > 0 ? c_deg[i - 1] : c_deg[planes - 1] - 360.0;
    const double after = i + 1 < planes ? c_deg[i + 1] : c_deg[0] + 360.0;
    const std::span row(candela.data() + i * gamma_deg.size(), gamma_deg.size());
    lumens += radians((after - before) / 2.0) * planeIntegral(gamma_deg, row);
  }
  return lumens;
}

double IntensityDistribution::peak() const {
  return candela.empty() ? 0.0 : *std::max_element(candela.begin(), candela.end());
}

}  // namespace soffit::photometry
