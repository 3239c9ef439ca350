// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// What a sensor measures: illuminances as weighted integrals of radiance over all directions,
/// E = ∫ L(w) W(w) dw. Formulas: EN 12665 (total flux on a small body over the body's area).
namespace soffit::reference {

/// The sensor's direction n is the normal (planar), the base's normal (hemispherical), the axis
/// (cylindrical) or the horizontal viewing direction (semicylindrical; the axis is then the
/// vertical, turned to be perpendicular to n). Unused by spherical.
enum class Quantity {
  planar,           ///< W = max(0, cos), cos to n
  cylindrical,      ///< W = sin / pi, sin to the axis n
  semicylindrical,  ///< W = (1 + cos of the azimuth from n) sin / pi, sin to the axis
  spherical,        ///< W = 1 / 4: flux on a small sphere over its surface (mean spherical)
  hemispherical     ///< W = (1 + cos) / 4, cos to n
};

/// W(w) of a quantity and directions drawn for it.
class Response {
 public:
  /// direction: unit.
  Response(Quantity quantity, const dvec3& direction);

  /// W(w), per steradian and lux of radiance cd/m²; w unit, pointing away from the sensor.
  [[nodiscard]] double weight(const dvec3& w) const;

  /// Density per steradian of sample(): cos / pi for planar, 1 / (4 pi) for the others.
  [[nodiscard]] double density(const dvec3& w) const;

  /// A direction with density() > 0 wherever W > 0; u in [0, 1)^2.
  [[nodiscard]] dvec3 sample(const dvec2& u) const;

  /// The normal of the half-space beyond which W is 0; the zero vector where there is none.
  [[nodiscard]] dvec3 horizon() const {
    return quantity_ == Quantity::planar ? normal_ : dvec3(0.0);
  }

 private:
  Quantity quantity_;
  dvec3 normal_;
  dvec3 axis_;  ///< of the cylinder
  dvec3 tangent_{0.0};
  dvec3 bitangent_{0.0};
};

}  // namespace soffit::reference
