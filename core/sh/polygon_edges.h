// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cmath>
#include <span>
#include <vector>

/// The outline of a light as arcs of great circles around the receiver.
namespace soffit::sh {

/// s(t) = start cos t + side sin t, t from 0 to angle, all unit; inward = start x side points into
/// the light.
struct Arc {
  dvec3 start, side, inward;
  double angle = 0.0;
  /// 1 / distance from the receiver to the edge where direction s meets it:
  /// |s x along| / height, with the edge's unit direction and the receiver's distance to its line.
  dvec3 along{0.0};
  double height = 0.0;

  [[nodiscard]] dvec3 at(double t) const { return std::cos(t) * start + std::sin(t) * side; }
  [[nodiscard]] double inverseDistance(double t) const {
    return glm::length(glm::cross(at(t), along)) / height;
  }
};

/// The arcs of an outline (counter-clockwise seen from its emitting side) around p, in the sense
/// that keeps the light inward for a receiver on the emitting side; edges that pass through p or
/// have no length are left out.
std::vector<Arc> arcsOf(std::span<const dvec3> outline, const dvec3& p);

}  // namespace soffit::sh
