// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <vector>

/// The CIE standard skies (ISO 15469:2004 / CIE S 011): relative luminance
///   L / L_zenith = f(chi) phi(Z) / (f(Z_s) phi(0)),
///   phi(Z) = 1 + a exp(b / cos Z),  f(chi) = 1 + c (exp(d chi) - exp(d pi / 2)) + e cos^2 chi,
/// Z from the zenith, chi from the sun, Z_s the sun's. Type 16 is the traditional overcast sky,
/// (1 + 2 sin h) / 3 of the zenith (Moon & Spencer 1942).
namespace soffit::daylight {

/// Gradation a, b and indicatrix c, d, e of a standard sky.
struct CieParameters {
  double a, b, c, d, e;
};

/// type 1..15.
CieParameters cieParameters(int type);

/// World direction to a point of the sky; azimuth from +y clockwise seen from above, radians.
dvec3 skyDirection(double azimuth, double altitude);

/// One sky, scaled so that an unobstructed horizontal plane receives `horizontal_illuminance` lux
/// from it, the sun's disc left out. The scale comes from quadrature with a relative error below
/// 1e-6.
class CieSky {
 public:
  /// type 1..16.   to_sun: unit; it may lie below the horizon.
  CieSky(int type, const dvec3& to_sun, double horizontal_illuminance);

  /// cd/m^2 from the unit direction d, d.z >= 0; at the horizon the limit from above.
  [[nodiscard]] double luminance(const dvec3& d) const { return zenith_luminance_ * relative(d); }
  /// The same from tables, for many receivers at once: relative error below 1e-5.
  [[nodiscard]] double quickLuminance(const dvec3& d) const;
  /// L / L_zenith.
  [[nodiscard]] double relative(const dvec3& d) const;

 private:
  int type_;
  CieParameters p_{};
  dvec3 to_sun_;
  double at_zenith_ = 1.0;  ///< f(Z_s) phi(0)
  double zenith_luminance_ = 1.0;
  std::vector<float> gradation_;   ///< by z = 0 .. 1
  std::vector<float> indicatrix_;  ///< by the chord to the sun, 0 .. 2, in which it has no cusp
};

}  // namespace soffit::daylight
