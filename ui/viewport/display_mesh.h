// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/specks.h"
#include "core/math/box.h"
#include "core/relight/lighting.h"
#include "core/scene/scene.h"
#include "core/transfer/operators.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::ui {

/// What the viewport draws of a building: triangles whose corners are display points, each with
/// the texels that its light is interpolated from. Static; only the light at the corners changes.
///
/// Charts are cut where light bends (chart_cutting.h). A side that carries no light (outer walls
/// from outside, insides of solids) is not drawn, so that one looks into a closed room from
/// outside; the other faces are wound counter-clockwise toward the side they belong to.
struct DisplayMesh {
  /// Triangles of one picture; those without come first.
  struct Part {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::shared_ptr<const scene::Image> map;  ///< null: none
  };

  /// A run of triangles that is looked at from one side, or not seen at all.
  struct Patch {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    Box bounds;
    bool planar = true;  ///< seen from where normal . eye > offset; else triangle by triangle
    vec3 normal{0.0F};
    float offset = 0.0F;
  };

  std::vector<vec3> positions;             ///< scene-local
  std::vector<vec3> albedo;                ///< per vertex, map not applied
  std::vector<std::uint32_t> material_of;  ///< per vertex
  /// Per vertex where any material has a lobe, else empty: unit shading normals on the side that is
  /// drawn, and f0 and alpha of the lobe.
  std::vector<vec3> normals;
  std::vector<vec2> gloss;
  std::vector<vec2> uvs;  ///< per vertex; empty when no part has a map
  /// Per material, null for those without: green is a share of the roughness. Empty: none has one.
  std::vector<std::shared_ptr<const scene::Image>> roughness_maps;
  std::vector<std::uint32_t> indices;
  std::vector<Part> parts;
  std::vector<Patch> patches;  ///< all indices, in order; none reaches over a part's end

  /// Light of vertex v = sum of weights[k] * light of slots[k], k in first[v] .. first[v + 1].
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> slots;
  std::vector<float> weights;

  /// Which vertices an edge joins: for isolux lines.
  std::shared_ptr<const design::Neighbours> neighbours;

  /// Per triangle of the building (solidTriangles()); null: not known.
  std::shared_ptr<const std::vector<std::uint8_t>> solid;

  [[nodiscard]] std::size_t vertexCount() const { return positions.size(); }
};

/// The indices of what an eye sees, part by part: patches within the picture that face it.
/// counts receives the number of indices per part; whole parts are left as they are when the mesh
/// has no patches. clip_from_scene: the camera. eye: its place and 1, or the direction toward an
/// eye that is infinitely far away and 0.
std::vector<std::uint32_t> visibleIndices(const DisplayMesh& mesh, const glm::mat4& clip_from_scene,
                                          const glm::vec4& eye, std::vector<std::uint32_t>& counts);

DisplayMesh makeDisplayMesh(const geometry::Mesh& mesh, const transfer::Texels& texels,
                            std::span<const scene::Material> materials);

/// The mesh with other reflectances of the same materials; maps stay.
DisplayMesh repainted(const DisplayMesh& mesh, std::span<const scene::Material> materials);

/// Whether materials have lobes that the mesh was not made for.
bool lacksNormals(const DisplayMesh& mesh, std::span<const scene::Material> materials);

/// RGB lux at each vertex. out.size() == vertexCount().
void lightVertices(const DisplayMesh& mesh, const relight::Planes& lux, std::span<vec3> out);

/// What the illuminance of each vertex is changed by, lux, so that isolux lines go round no specks
/// (design::findSpecks): within the error of the light. Empty: nothing is changed.
/// lux: RGB per vertex. levels: of the lines.
std::vector<float> withoutSpecks(const DisplayMesh& mesh, std::span<const vec3> lux,
                                 std::span<const double> levels);

}  // namespace soffit::ui
