// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"

/// From the triangles of a file to a Mesh that the rest may rely on.
namespace soffit::geometry {

/// Triangles as a file gives them, in metres, z up, double precision.
struct RawMesh {
  std::vector<dvec3> positions;
  std::vector<vec3> normals;     ///< empty or one per position; (0,0,0) where the file gives none
  std::vector<vec2> uvs;         ///< empty or one per position
  std::vector<uvec3> triangles;  ///< indices into positions
  std::vector<std::uint32_t> material_of;  ///< per triangle, index into `materials`
  std::vector<std::uint32_t> object_of;    ///< per triangle, index into `objects`
  std::vector<std::string> materials;      ///< unique
  std::vector<std::string> objects;
};

/// What cleaning found; counts of triangles unless stated.
struct CleaningReport {
  std::size_t triangles_in = 0;
  std::size_t triangles_out = 0;
  std::size_t non_finite = 0;    ///< dropped: a corner is infinite or not a number
  std::size_t degenerate = 0;    ///< dropped: no area at the model's scale
  std::size_t duplicate = 0;     ///< dropped: another triangle has the same three corners
  std::size_t turned = 0;        ///< turned over, to agree with their neighbors
  std::size_t made_normals = 0;  ///< triangles of which at least one corner had no normal
  std::size_t vertices_in = 0;   ///< vertices
  std::size_t vertices_out = 0;  ///< vertices

  [[nodiscard]] std::size_t dropped() const { return non_finite + degenerate + duplicate; }
};

struct CleanedMesh {
  Mesh mesh;
  CleaningReport report;
};

/// Cleans a triangle soup.
///
/// - Points closer than weldTolerance() become one point, with bit-equal coordinates; vertices
///   that also agree in normal and texture coordinates become one vertex. Hard edges stay.
/// - Dropped and counted: triangles with a corner that is not finite; without area (two corners
///   in one point, or lower than the weld tolerance); duplicates, i.e. the same three points in
///   any order. Two faces of opposite winding stay if each closes a solid of its own: cabinets
///   side by side keep their touching walls.
/// - Where the triangles of a part are wound in different ways, they are made to agree
///   (orientation.h): solids get their fronts outward.
/// - Missing normals are made: the mean of the faces about the point, weighted by the angle they
///   have there, over faces of the same object within `crease_deg` of the corner's own face.
///   Given normals are scaled to unit length, and negated where they point to a triangle's back.
/// - Mesh::origin is (0,0,0) unless the model lies so far out that single precision would hurt:
///   farther than 10 km, or than 1 km and 100 times its diagonal; then its center in whole metres.
///
/// Every array of the result is complete (normals always; uvs if `raw` has any; material_of and
/// object_of one per triangle). The order of triangles is kept. Indices of `raw` out of range are
/// the caller's fault. O(n log n); the result does not depend on the thread count.
CleanedMesh cleanMesh(const RawMesh& raw, double crease_deg = 40.0);

/// Joins meshes (the files of a project) into one frame; materials of equal name become one.
/// Coincident triangles of different meshes are all kept. The origin is chosen anew.
Mesh mergeMeshes(const std::vector<Mesh>& meshes);

}  // namespace soffit::geometry
