// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <string>
#include <vector>

namespace soffit::photometry {

/// Far-field luminous intensity of a luminaire over the whole sphere, as measured.
///
/// Frame of the luminaire: gamma 0 is -z, gamma 180 is +z; C 0 is +x, C 90 is +y (C runs
/// counter-clockwise seen from above). Type A and B tables are resampled to this frame by the
/// readers without changing their lumens.
struct IntensityDistribution {
  std::vector<double>
      c_deg;  ///< ascending, first 0, last < 360 (closed by the first) or just {0}: axial
  std::vector<double>
      gamma_deg;                ///< ascending, within 0..180; outside the range the intensity is 0
  std::vector<double> candela;  ///< row-major [c][gamma], cd, all factors of the file applied
  dvec3 opening{
      0.0};  ///< luminous opening in metres along x, y, z; negative x or y: round; 0 0 0: a point
  std::string name;  ///< what the file calls the luminaire

  /// cd toward `direction` (unit, luminaire frame): linear in gamma and in C.
  [[nodiscard]] double intensity(const dvec3& direction) const;
  /// The same by angles in degrees: any C (taken modulo 360), gamma in 0..180.
  [[nodiscard]] double intensityAt(double angle_c_deg, double angle_gamma_deg) const;
  /// Lumens: integral over the sphere, piecewise linear in gamma with the exact sine, trapezoid in
  /// C.
  [[nodiscard]] double flux() const;
  /// The greatest entry, cd.
  [[nodiscard]] double peak() const;
};

}  // namespace soffit::photometry
