// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

namespace soffit::reference {

/// A rectangle seen from a point: its solid angle, and points on it that are uniform in solid
/// angle. Source: Ureña, Fajardo & King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles", section 3. Exact up to rounding while the solid angle is above about 1e-6.
class SphericalRectangle {
 public:
  /// corner, and two perpendicular edges; y must not lie in their plane.
  SphericalRectangle(const dvec3& corner, const dvec3& edge_x, const dvec3& edge_y, const dvec3& y);

  [[nodiscard]] double solidAngle() const { return solid_angle_; }

  /// A point of the rectangle for u in [0, 1)^2.
  [[nodiscard]] dvec3 sample(const dvec2& u) const;

 private:
  dvec3 from_;
  dvec3 x_axis_;
  dvec3 y_axis_;
  dvec3 z_axis_;
  double x0_, x1_, y0_, y1_, z0_;
  double b0_ = 0.0;
  double b1_ = 0.0;
  double k_ = 0.0;
  double solid_angle_ = 0.0;
};

}  // namespace soffit::reference
