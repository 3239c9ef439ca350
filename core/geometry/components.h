// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/math/box.h"

/// Connected parts of a mesh, and which of them are solids.
///
/// A closed, consistently wound component has an inside that no light reaches, so the engine puts
/// receivers on its outside only; see core/geometry/README.md.
namespace soffit::geometry {

/// Triangles that hang together over edges.
struct Component {
  std::vector<std::uint32_t> triangles;  ///< indices into the mesh, ascending
  Box bounds;                            ///< metres, in the mesh's frame (relative to its origin)
  bool closed = false;                   ///< every edge belongs to two triangles of this component
  bool consistent = false;               ///< neighbors run along their common edge in opposite ways
  /// Enclosed volume, m3; positive when the fronts face outward. Meaningless unless solid().
  double signed_volume = 0.0;

  [[nodiscard]] bool solid() const { return closed && consistent; }
  [[nodiscard]] bool outward() const { return signed_volume > 0.0; }
};

struct Components {
  std::vector<Component> list;              ///< in the order of their first triangle
  std::vector<std::uint32_t> component_of;  ///< per triangle, index into `list`
  std::vector<std::uint32_t> point_of;      ///< per vertex, first vertex at the same point
};

/// Splits a mesh into connected components. Vertices are welded by position, so faces that do not
/// share indices (hard edges, one object per face) still join.
///
/// Where more than two triangles meet at an edge (two cabinets side by side), they are sorted
/// around it and joined in pairs that bound a wedge of solid matter, fronts outward; what finds no
/// partner counts as an open border. Triangles with two equal corners are open components of
/// their own. O(n log n).
Components findComponents(const Mesh& mesh);

/// Whether a point (in the mesh's frame) lies inside a closed component: the winding number from
/// the triangles' solid angles (van Oosterom & Strackee 1983) rounds to something other than 0.
/// For points within a rounding of the surface either answer may come. O(triangles), after a test
/// of the bounds.
bool contains(const Mesh& mesh, const Component& component, const vec3& point);

}  // namespace soffit::geometry
