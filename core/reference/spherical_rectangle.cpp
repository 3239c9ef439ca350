// SPDX-License-Identifier: MIT
#include "core/reference/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

/// Lengths here are metres, far from where squares overflow: no need of hypot's care.
double root(double a, double b) {
  return std::sqrt(a * a + b * b);
}

}  // namespace

SphericalRectangle::SphericalRectangle(const dvec3& corner, const dvec3& edge_x,
                                       const dvec3& edge_y, const dvec3& y)
    : from_(y) {
  const double width = glm::length(edge_x);
  const double height = glm::length(edge_y);
  x_axis_ = edge_x / width;
  y_axis_ = edge_y / height;
  z_axis_ = glm::cross(x_axis_, y_axis_);
  const dvec3 d = corner - y;
  z0_ = glm::dot(d, z_axis_);
  // The rectangle lies on the negative z side of the frame at y.
  if (z0_ > 0.0) {
    z_axis_ = -z_axis_;
    z0_ = -z0_;
  }
  x0_ = glm::dot(d, x_axis_);
  y0_ = glm::dot(d, y_axis_);
  x1_ = x0_ + width;
  y1_ = y0_ + height;
  // The planes through y and each edge have normals with z components b (before and after in
  // turn: bottom, right, top, left); their angles give the solid angle by Girard's theorem.
  const auto zOfNormal = [](double in_plane, double z) { return in_plane / root(in_plane, z); };
  const double bottom = -zOfNormal(y0_, z0_);
  const double right = zOfNormal(x1_, z0_);
  const double top = zOfNormal(y1_, z0_);
  const double left = -zOfNormal(x0_, z0_);
  const double g0 = std::acos(std::clamp(-bottom * right, -1.0, 1.0));
  const double g1 = std::acos(std::clamp(-right * top, -1.0, 1.0));
  const double g2 = std::acos(std::clamp(-top * left, -1.0, 1.0));
  const double g3 = std::acos(std::clamp(-left * bottom, -1.0, 1.0));
  b0_ = bottom;
  b1_ = top;
  k_ = 2.0 * kPi - g2 - g3;
  solid_angle_ = std::max(0.0, g0 + g1 - k_);
}

dvec3 SphericalRectangle::sample(const dvec2& u) const {
  const double area = u.x * solid_angle_ + k_;
  const double fu = (std::cos(area) * b0_ - b1_) / std::sin(area);
  const double cu = std::clamp(std::copysign(1.0 / std::sqrt(fu * fu + b0_ * b0_), fu), -1.0, 1.0);
  const double sine = std::sqrt(std::max(1.0 - cu * cu, 1e-300));
  const double x = std::clamp(-(cu * z0_) / sine, x0_, x1_);
  const double d = root(x, z0_);
  const double h0 = y0_ / root(d, y0_);
  const double h1 = y1_ / root(d, y1_);
  const double h = h0 + u.y * (h1 - h0);
  const double h_squared = h * h;
  const double y = h_squared < 1.0 - 1e-12 ? h * d / std::sqrt(1.0 - h_squared) : y1_;
  return from_ + x * x_axis_ + std::clamp(y, y0_, y1_) * y_axis_ + z0_ * z_axis_;
}

}  // namespace soffit::reference
