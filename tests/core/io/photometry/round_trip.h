// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"
#include "tests/core/photometry/distributions.h"

#include <functional>

namespace soffit::io {

/// A synthetic luminaire of a formula in C and gamma (radians).
inline PhotometricFile synthetic(const std::function<double(double, double)>& candela, int c_count,
                                 int gamma_count = 37, double gamma_last_deg = 180.0) {
  PhotometricFile file;
  file.distribution = photometry::tabulate(candela, c_count, gamma_count, 0.0, gamma_last_deg);
  file.distribution.name = "Synthetic";
  file.distribution.opening = {0.3, 0.6, 0.05};
  file.lumens = file.distribution.flux();
  file.absolute = true;
  file.watts = 12.5;
  return file;
}

/// Candela with each symmetry; made exactly symmetric by folding the angle first.
inline double foldedAngle(double c, bool about_c0, bool about_c90) {
  double degrees_c = std::round(degrees(c) * 1e6) / 1e6;
  if (about_c0 && degrees_c > 180.0) degrees_c = 360.0 - degrees_c;
  if (about_c90) {
    if (degrees_c > 270.0) degrees_c -= 360.0;
    if (degrees_c > 90.0) degrees_c = 180.0 - degrees_c;
  }
  return radians(degrees_c);
}

}  // namespace soffit::io
