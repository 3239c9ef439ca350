// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/components.h"
#include "core/geometry/mesh.h"

/// A mesh as few convex, planar faces: what shadows are cast from.
namespace soffit::geometry {

/// A convex planar polygon, metres in the mesh's frame, counter-clockwise seen from its front.
struct ConvexFace {
  std::array<vec3, 4> corners{};  ///< the first `count` are meant
  int count = 3;                  ///< 3 or 4
  std::uint32_t component = 0;    ///< index into Components::list
  std::uint32_t material = 0;     ///< Mesh::material_of of its triangles
  std::uint32_t triangles = 0;    ///< how many it was merged from
};

struct ConvexFaces {
  std::vector<ConvexFace> faces;
  std::vector<std::uint32_t> face_of;  ///< per triangle of the mesh, index into `faces`
};

/// Merges coplanar neighbors of one component and one material into convex polygons with at most
/// four corners, longest common edge first, until nothing more merges: the two triangles of a
/// rectangle become one face, and so does a whole tessellated wall if its grid allows.
///
/// The faces cover what the triangles cover, each point once; "coplanar" and "straight" allow
/// 2^-21 of the model's largest coordinate or 1e-6 of the face's size, whichever is more (a few
/// micrometres in a room). Triangles are never split. O(n log n) and a few passes.
ConvexFaces mergeConvexFaces(const Mesh& mesh, const Components& components);

}  // namespace soffit::geometry
