// SPDX-License-Identifier: MIT
#include "core/photometry/goniometer.h"

#include "core/photometry/angle_lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace soffit::photometry {
namespace {

// Rounding of asin and atan2 must not put the edge of the table outside of it.
constexpr double kEdgeDeg = 1e-9;

bool within(std::span<const double> knots, double x) {
  return x >= knots.front() - kEdgeDeg && x <= knots.back() + kEdgeDeg;
}

/// Bracket that also serves a single knot.
Bracket find(std::span<const double> knots, double x) {
  return knots.size() < 2 ? Bracket{} : bracket(knots, x);
}

/// ∫ f cos x dx for f linear between the knots (degrees in, radians inside).
template <class Value>
double cosineIntegral(std::span<const double> knots_deg, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < knots_deg.size(); ++i) {
    const double x0 = radians(knots_deg[i]);
    const double x1 = radians(knots_deg[i + 1]);
    // (cos x₀ - cos x₁)/(x₁ - x₀) without cancellation, as sin of the middle times a sinc.
    const double half = (x1 - x0) / 2.0;
    const double mean_sine = std::sin((x0 + x1) / 2.0) * (half > 0.0 ? std::sin(half) / half : 1.0);
    sum += value(i + 1) * std::sin(x1) - value(i) * std::sin(x0) -
           (value(i + 1) - value(i)) * mean_sine;
  }
  return sum;
}

/// Trapezoid over knots in degrees, result per radian.
template <class Value>
double trapezoid(std::span<const double> knots_deg, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < knots_deg.size(); ++i) {
    sum += radians(knots_deg[i + 1] - knots_deg[i]) * (value(i) + value(i + 1)) / 2.0;
  }
  return sum;
}

double finestStep(std::span<const double> knots) {
  double step = 180.0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) step = std::min(step, knots[i + 1] - knots[i]);
  return step;
}

/// The greatest of `steps` (descending) that does not exceed `wanted`, else the last.
double chosenStep(std::span<const double> steps, double wanted) {
  const auto it = std::find_if(steps.begin(), steps.end(), [&](double s) { return s <= wanted; });
  return it != steps.end() ? *it : steps.back();
}

std::vector<double> ramp(int count, double step) {
  std::vector<double> knots(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i] = static_cast<double>(i) * step;
  return knots;
}

double greatestMagnitude(std::span<const double> knots) {
  return std::max(std::abs(knots.front()), std::abs(knots.back()));
}

dvec3 fromCGamma(double c_deg, double gamma_deg) {
  const double c = radians(c_deg);
  const double gamma = radians(gamma_deg);
  return {std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma)};
}

}  // namespace

double gonioIntensity(const GonioTable& table, const dvec3& direction) {
  const bool is_b = table.type == GonioType::b;
  const double down = -direction.z;
  const double latitude =
      degrees(std::asin(std::clamp(is_b ? direction.y : direction.x, -1.0, 1.0)));
  const double longitude = degrees(std::atan2(is_b ? direction.x : direction.y, down));
  const double v = is_b ? longitude : latitude;
  double h = is_b ? latitude : longitude;
  if (table.mirrored) h = std::abs(h);
  if (!within(table.vertical_deg, v) || !within(table.horizontal_deg, h)) return 0.0;
  const Bracket bv = find(table.vertical_deg, v);
  const Bracket bh = find(table.horizontal_deg, h);
  const auto along = [&](std::size_t row) {
    const double* cd = table.candela.data() + row * table.vertical_deg.size() + bv.index;
    return cd[0] + bv.t * (cd[1] - cd[0]);
  };
  const double lower = along(bh.index);
  return bh.t == 0.0 ? lower : lower + bh.t * (along(bh.index + 1) - lower);
}

double gonioFlux(const GonioTable& table) {
  const std::span<const double> v = table.vertical_deg;
  const std::span<const double> h = table.horizontal_deg;
  const auto candela = [&](std::size_t ih, std::size_t iv) {
    return table.candela[ih * v.size() + iv];
  };
  double lumens = 0.0;
  if (table.type == GonioType::b) {
    lumens = trapezoid(v, [&](std::size_t iv) {
      return cosineIntegral(h, [&](std::size_t ih) { return candela(ih, iv); });
    });
  } else {
    lumens = trapezoid(h, [&](std::size_t ih) {
      return cosineIntegral(v, [&](std::size_t iv) { return candela(ih, iv); });
    });
  }
  return table.mirrored ? 2.0 * lumens : lumens;
}

IntensityDistribution toCGamma(const GonioTable& table) {
  assert(table.vertical_deg.size() >= 2 && table.horizontal_deg.size() >= 2);
  assert(table.candela.size() == table.vertical_deg.size() * table.horizontal_deg.size());
  constexpr double kGammaSteps[] = {1.0, 0.5, 0.25, 0.1, 0.05};
  constexpr double kCSteps[] = {2.5, 2.0, 1.0};  // each divides 90: the principal planes are there
  const double finest = std::min(finestStep(table.vertical_deg), finestStep(table.horizontal_deg));
  const double gamma_step = chosenStep(kGammaSteps, finest / 2.0);
  const double c_step = chosenStep(kCSteps, finest / 2.0);
  const bool is_b = table.type == GonioType::b;
  // Only the longitude can pass the horizon; without that there is nothing above it.
  const double reach = greatestMagnitude(is_b ? table.vertical_deg : table.horizontal_deg);
  const double gamma_end = reach > 90.0 + kEdgeDeg ? 180.0 : 90.0;

  IntensityDistribution d;
  d.c_deg = ramp(static_cast<int>(std::lround(360.0 / c_step)), c_step);
  d.gamma_deg = ramp(static_cast<int>(std::lround(gamma_end / gamma_step)) + 1, gamma_step);
  d.gamma_deg.back() = gamma_end;
  d.candela.reserve(d.c_deg.size() * d.gamma_deg.size());
  for (const double c : d.c_deg) {
    for (const double gamma : d.gamma_deg) {
      d.candela.push_back(gonioIntensity(table, fromCGamma(c, gamma)));
    }
  }
  const double sampled = d.flux();
  if (sampled > 0.0) {
    const double scale = gonioFlux(table) / sampled;
    for (double& cd : d.candela) cd *= scale;
  }
  return d;
}

}  // namespace soffit::photometry
