// SPDX-License-Identifier: MIT
#include "core/reference/quantity.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

/// The vertical made perpendicular to the viewing direction; for a vertical viewing direction any
/// perpendicular will do, since no azimuth is defined there.
dvec3 cylinderAxis(const dvec3& view) {
  const dvec3 up(0.0, 0.0, 1.0);
  const dvec3 axis = up - glm::dot(up, view) * view;
  const double length = glm::length(axis);
  if (length > 1e-9) return axis / length;
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(view, t, b);
  return t;
}

double sineTo(const dvec3& axis, const dvec3& w) {
  return glm::length(glm::cross(axis, w));
}

}  // namespace

Response::Response(Quantity quantity, const dvec3& direction)
    : quantity_(quantity),
      normal_(direction),
      axis_(quantity == Quantity::semicylindrical ? cylinderAxis(direction) : direction) {
  orthonormalBasis(normal_, tangent_, bitangent_);
}

double Response::weight(const dvec3& w) const {
  switch (quantity_) {
    case Quantity::planar:
      return std::max(0.0, glm::dot(normal_, w));
    case Quantity::cylindrical:
      return sineTo(axis_, w) / kPi;
    // (1 + cos azimuth) sin: the sine times the cosine of the azimuth is w's component along n.
    case Quantity::semicylindrical:
      return (sineTo(axis_, w) + glm::dot(normal_, w)) / kPi;
    case Quantity::spherical:
      return 0.25;
    case Quantity::hemispherical:
      return 0.25 * (1.0 + glm::dot(normal_, w));
  }
  return 0.0;
}

double Response::density(const dvec3& w) const {
  if (quantity_ == Quantity::planar) return std::max(0.0, glm::dot(normal_, w)) / kPi;
  return 1.0 / (4.0 * kPi);
}

dvec3 Response::sample(const dvec2& u) const {
  const double phi = 2.0 * kPi * u.y;
  const bool cosine = quantity_ == Quantity::planar;
  const double z = cosine ? std::sqrt(1.0 - u.x) : 1.0 - 2.0 * u.x;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return r * std::cos(phi) * tangent_ + r * std::sin(phi) * bitangent_ + z * normal_;
}

}  // namespace soffit::reference
