// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/intensity_distribution.h"

#include <functional>

/// Tables made from a formula, for tests.
namespace soffit::photometry {

/// I(C, gamma) in radians sampled on equidistant knots; c_count 1 is axial.
inline IntensityDistribution tabulate(const std::function<double(double, double)>& candela,
                                      int c_count, int gamma_count, double gamma_first_deg = 0.0,
                                      double gamma_last_deg = 180.0) {
  IntensityDistribution d;
  for (int i = 0; i < c_count; ++i) d.c_deg.push_back(360.0 * i / c_count);
  for (int i = 0; i < gamma_count; ++i) {
    d.gamma_deg.push_back(gamma_first_deg +
                          (gamma_last_deg - gamma_first_deg) * i / (gamma_count - 1));
  }
  for (const double c : d.c_deg) {
    for (const double gamma : d.gamma_deg) d.candela.push_back(candela(radians(c), radians(gamma)));
  }
  return d;
}

/// Unit direction of C and gamma in degrees, luminaire frame.
inline dvec3 toward(double c_deg, double gamma_deg) {
  const double c = radians(c_deg);
  const double g = radians(gamma_deg);
  return {std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g)};
}

}  // namespace soffit::photometry
