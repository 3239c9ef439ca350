// SPDX-License-Identifier: MIT
#include "core/sh/polygon_edges.h"

namespace soffit::sh {

std::vector<Arc> arcsOf(std::span<const dvec3> outline, const dvec3& p) {
  std::vector<Arc> arcs;
  arcs.reserve(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    // Backwards: counter-clockwise towards the receiver is clockwise about the direction to it.
    const dvec3 b = outline[i] - p;
    const dvec3 a = outline[(i + 1) % outline.size()] - p;
    const dvec3 normal = glm::cross(a, b);
    const double sine = glm::length(normal);
    if (!(sine > 0.0)) continue;
    Arc arc;
    arc.start = glm::normalize(a);
    arc.inward = normal / sine;
    arc.side = glm::cross(arc.inward, arc.start);
    arc.angle = std::atan2(sine, glm::dot(a, b));
    const double length = glm::length(b - a);
    arc.along = (b - a) / length;
    arc.height = sine / length;
    arcs.push_back(arc);
  }
  return arcs;
}

}  // namespace soffit::sh
