// SPDX-License-Identifier: MIT
#include "ui/viewport/display_mesh.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "ui/viewport/chart_cutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace soffit::ui {
namespace {

vec3 albedoOf(const scene::Material& material) {
  return material.glass ? vec3(0.0F) : vec3(material.diffuse);
}

vec2 glossOf(const scene::Material& material) {
  if (material.glass) return vec2(0.0F);
  return {material.specular, material.roughness * material.roughness};
}

bool anyGloss(std::span<const scene::Material> materials) {
  return std::ranges::any_of(materials,
                             [](const scene::Material& m) { return glossOf(m).x > 0.0F; });
}

/// Corners of curved charts share their light when their charts look within 60 degrees of each
/// other: a cylinder is smooth, a box is not.
constexpr float kSmoothCosine = 0.5F;

/// Light at a vertex as shares of texels.
struct Row {
  std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
  std::array<float, transfer::Texels::kMostAround> weights{};
  int count = 0;
};

class Builder {
 public:
  Builder(const geometry::Mesh& mesh, const transfer::Texels& texels,
          std::span<const scene::Material> materials)
      : mesh_(mesh), texels_(texels), materials_(materials) {
    out_.first.push_back(0);
  }

  DisplayMesh build() {
    has_gloss_ = anyGloss(materials_);
    const bool rough = has_gloss_ && takeRoughnessMaps();
    has_maps_ = !mesh_.uvs.empty() &&
                (rough || std::ranges::any_of(materials_, [](const scene::Material& m) {
                   return m.diffuse_image != nullptr;
                 }));
    collectCorners();
    for (std::uint32_t c = 0; c < texels_.charts.charts.size(); ++c) {
      const transfer::Chart& chart = texels_.charts.charts[c];
      int side = 0;
      for (const bool front : {true, false}) {
        if ((chart.sides & (front ? transfer::kFront : transfer::kBack)) == 0) continue;
        const std::size_t first = indexCount(chart);
        if (chart.planar) {
          addPlanar(c, side, front);
        } else {
          addCurved(c, front);
        }
        closePatch(chart, front, first);
        ++side;
      }
    }
    joinParts();
    return std::move(out_);
  }

 private:
  /// Whether there are any.
  bool takeRoughnessMaps() {
    if (mesh_.uvs.empty() || std::ranges::all_of(materials_, [](const scene::Material& m) {
          return m.roughness_image == nullptr;
        })) {
      return false;
    }
    for (const scene::Material& m : materials_) out_.roughness_maps.push_back(m.roughness_image);
    return true;
  }

  [[nodiscard]] std::uint32_t materialOf(std::uint32_t triangle) const {
    return mesh_.material_of.empty() ? 0 : mesh_.material_of[triangle];
  }

  /// The normal at a place of a chart's side: `mixed` of the mesh's, where it has any.
  [[nodiscard]] static vec3 sideNormal(const transfer::Chart& chart, bool front,
                                       const vec3& mixed) {
    const vec3 n = glm::dot(mixed, mixed) > 0.0F ? glm::normalize(mixed) : chart.normal;
    return (glm::dot(n, chart.normal) < 0.0F) == front ? -n : n;
  }

  std::uint32_t addVertex(const vec3& position, const vec3& normal, const vec2& uv,
                          std::uint32_t material, const Row& row) {
    const auto index = static_cast<std::uint32_t>(out_.positions.size());
    out_.positions.push_back(position);
    out_.albedo.push_back(albedoOf(materials_[material]));
    out_.material_of.push_back(material);
    if (has_maps_) out_.uvs.push_back(uv);
    if (has_gloss_) {
      out_.normals.push_back(normal);
      out_.gloss.push_back(glossOf(materials_[material]));
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k) {
      out_.slots.push_back(row.slots[k]);
      out_.weights.push_back(row.weights[k]);
    }
    out_.first.push_back(static_cast<std::uint32_t>(out_.slots.size()));
    return index;
  }

  void addTriangle(uvec3 corners, bool front, std::uint32_t material) {
    if (!front) std::swap(corners.y, corners.z);
    Run& run = by_map_[materials_[material].diffuse_image];
    run.indices.insert(run.indices.end(), {corners.x, corners.y, corners.z});
  }

  /// What was added to a map's run since `first` is one patch.
  void closePatch(const transfer::Chart& chart, bool front, std::size_t first) {
    Run& run = by_map_[materials_[chart.material].diffuse_image];
    if (run.indices.size() == first) return;
    DisplayMesh::Patch patch;
    patch.first_index = static_cast<std::uint32_t>(first);
    patch.index_count = static_cast<std::uint32_t>(run.indices.size() - first);
    for (std::size_t k = first; k < run.indices.size(); ++k) {
      patch.bounds.add(out_.positions[run.indices[k]]);
    }
    patch.planar = chart.planar;
    patch.normal = front ? chart.normal : -chart.normal;
    // The corners of a chart are coplanar up to rounding: a hair nearer to the eye is enough.
    patch.offset = glm::dot(patch.normal, chart.origin) - 1e-4F;
    run.patches.push_back(patch);
  }
  [[nodiscard]] std::size_t indexCount(const transfer::Chart& chart) {
    return by_map_[materials_[chart.material].diffuse_image].indices.size();
  }

  /// The texel of the very cell that a point of a planar chart lies in; none under matter.
  [[nodiscard]] std::uint32_t slotUnder(std::uint32_t c, int side, const vec3& point) const {
    const transfer::Chart& chart = texels_.charts.charts[c];
    const transfer::Texels::Grid& grid = texels_.grids[c];
    const vec3 d = point - chart.origin;
    const int i = std::clamp(static_cast<int>(glm::dot(d, chart.t) / grid.cell.x), 0, grid.nu - 1);
    const int j = std::clamp(static_cast<int>(glm::dot(d, chart.b) / grid.cell.y), 0, grid.nv - 1);
    return texels_
        .cells[grid.first + static_cast<std::uint32_t>((side * grid.nv + j) * grid.nu + i)];
  }
  [[nodiscard]] std::uint32_t partUnder(std::uint32_t c, int side, const vec3& point) const {
    const std::uint32_t slot = slotUnder(c, side, point);
    return slot == transfer::kNoTexel ? transfer::kNoTexel : texels_.part[slot];
  }

  /// One side of a planar chart on its way into the mesh.
  struct Planar {
    std::uint32_t chart;
    int side;
    bool front;
    const CutChart& cut;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> parts;  ///< kNoTexel: under matter
    std::vector<std::uint32_t> index;  ///< in the mesh
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> others;  ///< (vertex, part)
  };

  std::uint32_t addPlanarVertex(const Planar& p, std::uint32_t v, const vec3& light_from) {
    const CutChart::Vertex& vertex = p.cut.vertices[v];
    Row row;
    row.count = texels_.around(vertex.triangle, p.front, light_from, row.slots, row.weights);
    const transfer::Chart& chart = texels_.charts.charts[p.chart];
    const bool bent = has_gloss_ && !mesh_.normals.empty();
    return addVertex(p.positions[v],
                     sideNormal(chart, p.front, bent ? mixed(vertex, mesh_.normals) : chart.normal),
                     has_maps_ ? mixed(vertex, mesh_.uvs) : vec2(0.0F), chart.material, row);
  }

  template <class T>
  [[nodiscard]] T mixed(const CutChart::Vertex& vertex, const std::vector<T>& values) const {
    const uvec3& t = mesh_.triangles[vertex.triangle];
    return (1.0F - vertex.barycentric.x - vertex.barycentric.y) * values[t.x] +
           vertex.barycentric.x * values[t.y] + vertex.barycentric.y * values[t.z];
  }

  /// The vertex as a triangle about `center` sees it. A corner under a wall, or behind it, would
  /// bring the light of the wall's other side; it takes the light from nearer to the center.
  std::uint32_t vertexFor(Planar& p, std::uint32_t v, const vec3& center, std::uint32_t part) {
    if (part == transfer::kNoTexel || p.parts[v] == part) return p.index[v];
    const auto [found, added] = p.others.try_emplace({v, part}, p.index[v]);
    if (!added) return found->second;
    for (const float way : {0.25F, 0.5F, 0.75F, 1.0F}) {
      const vec3 from = glm::mix(p.positions[v], center, way);
      if (partUnder(p.chart, p.side, from) != part) continue;
      found->second = addPlanarVertex(p, v, from);
      break;
    }
    return found->second;
  }

  void addPlanar(std::uint32_t c, int side, bool front) {
    const CutChart cut = cutChart(mesh_, texels_, c, side);
    Planar p{c, side, front, cut, {}, {}, {}, {}};
    for (std::uint32_t v = 0; v < cut.vertices.size(); ++v) {
      p.positions.push_back(mixed(cut.vertices[v], mesh_.positions));
      p.parts.push_back(partUnder(c, side, p.positions.back()));
      p.index.push_back(addPlanarVertex(p, v, p.positions.back()));
    }
    for (const uvec3& t : cut.triangles) {
      vec3 center = (p.positions[t.x] + p.positions[t.y] + p.positions[t.z]) / 3.0F;
      const bool alike = p.parts[t.x] == p.parts[t.y] && p.parts[t.y] == p.parts[t.z];
      std::uint32_t part = alike ? p.parts[t.x] : partUnder(c, side, center);
      // What is seen of a triangle that mostly lies under matter is lit as its corner outside is.
      for (int k = 0; k < 3 && part == transfer::kNoTexel; ++k) {
        part = p.parts[t[k]];
        if (part != transfer::kNoTexel) center = p.positions[t[k]];
      }
      addTriangle({vertexFor(p, t.x, center, part), vertexFor(p, t.y, center, part),
                   vertexFor(p, t.z, center, part)},
                  front, texels_.charts.charts[c].material);
    }
  }

  /// The texel of each curved chart at each corner of the mesh, by place.
  struct Corner {
    std::uint32_t chart;
    std::uint32_t material;
  };
  using Place = std::array<std::int64_t, 3>;
  [[nodiscard]] Place placeOf(std::uint32_t vertex) const {
    constexpr float kPerMetre = 16384.0F;
    const vec3 p = mesh_.positions[vertex] * kPerMetre;
    return {std::llround(p.x), std::llround(p.y), std::llround(p.z)};
  }

  void collectCorners() {
    for (std::uint32_t c = 0; c < texels_.charts.charts.size(); ++c) {
      const transfer::Chart& chart = texels_.charts.charts[c];
      if (chart.planar) continue;
      for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
        const uvec3& t = mesh_.triangles[texels_.charts.triangles[chart.first_triangle + k]];
        for (int corner = 0; corner < 3; ++corner) {
          std::vector<Corner>& list = corners_[placeOf(t[corner])];
          if (list.empty() || list.back().chart != c) list.push_back({c, chart.material});
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t slotOf(std::uint32_t c, bool front) const {
    const transfer::Chart& chart = texels_.charts.charts[c];
    return texels_.at(texels_.charts.triangles[chart.first_triangle], front, vec3(0.0F));
  }

  [[nodiscard]] Row curvedRow(std::uint32_t c, bool front, std::uint32_t vertex) const {
    const transfer::Chart& own = texels_.charts.charts[c];
    Row row;
    for (const Corner& corner : corners_.at(placeOf(vertex))) {
      const transfer::Chart& other = texels_.charts.charts[corner.chart];
      if (row.count == static_cast<int>(transfer::Texels::kMostAround)) break;
      if (corner.material != own.material || glm::dot(other.normal, own.normal) < kSmoothCosine) {
        continue;
      }
      if ((other.sides & (front ? transfer::kFront : transfer::kBack)) == 0) continue;
      const std::uint32_t slot = slotOf(corner.chart, front);
      if (slot == transfer::kNoTexel) continue;
      row.slots[static_cast<std::size_t>(row.count++)] = slot;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k) {
      row.weights[k] = 1.0F / static_cast<float>(row.count);
    }
    return row;
  }

  void addCurved(std::uint32_t c, bool front) {
    const transfer::Chart& chart = texels_.charts.charts[c];
    std::unordered_map<std::uint32_t, std::uint32_t> index;
    for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
      const uvec3& t = mesh_.triangles[texels_.charts.triangles[chart.first_triangle + k]];
      uvec3 corners;
      for (int i = 0; i < 3; ++i) {
        const auto [found, added] = index.try_emplace(t[i], 0U);
        if (added) {
          const vec3 normal = mesh_.normals.empty() ? chart.normal : mesh_.normals[t[i]];
          found->second = addVertex(mesh_.positions[t[i]], sideNormal(chart, front, normal),
                                    has_maps_ ? mesh_.uvs[t[i]] : vec2(0.0F), chart.material,
                                    curvedRow(c, front, t[i]));
        }
        corners[i] = found->second;
      }
      addTriangle(corners, front, chart.material);
    }
  }

  void joinParts() {
    // Null sorts first.
    for (const auto& [map, run] : by_map_) {
      const auto first = static_cast<std::uint32_t>(out_.indices.size());
      out_.parts.push_back({first, static_cast<std::uint32_t>(run.indices.size()), map});
      out_.indices.insert(out_.indices.end(), run.indices.begin(), run.indices.end());
      for (DisplayMesh::Patch patch : run.patches) {
        patch.first_index += first;
        out_.patches.push_back(patch);
      }
    }
  }

  /// The triangles with one map.
  struct Run {
    std::vector<std::uint32_t> indices;
    std::vector<DisplayMesh::Patch> patches;
  };

  const geometry::Mesh& mesh_;
  const transfer::Texels& texels_;
  std::span<const scene::Material> materials_;
  bool has_maps_ = false;
  bool has_gloss_ = false;
  std::map<Place, std::vector<Corner>> corners_;
  std::map<std::shared_ptr<const scene::Image>, Run> by_map_;
  DisplayMesh out_;
};

}  // namespace

DisplayMesh makeDisplayMesh(const geometry::Mesh& mesh, const transfer::Texels& texels,
                            std::span<const scene::Material> materials) {
  if (texels.slotCount() == 0) return {};
  DisplayMesh built = Builder(mesh, texels, materials).build();
  built.neighbours = std::make_shared<const design::Neighbours>(
      design::meshNeighbours(built.vertexCount(), built.indices));
  return built;
}

DisplayMesh repainted(const DisplayMesh& mesh, std::span<const scene::Material> materials) {
  DisplayMesh painted = mesh;
  for (std::size_t v = 0; v < painted.albedo.size(); ++v) {
    painted.albedo[v] = albedoOf(materials[mesh.material_of[v]]);
  }
  if (!anyGloss(materials)) painted.gloss.clear();
  for (std::size_t v = 0; v < painted.gloss.size(); ++v) {
    painted.gloss[v] = glossOf(materials[mesh.material_of[v]]);
  }
  return painted;
}

bool lacksNormals(const DisplayMesh& mesh, std::span<const scene::Material> materials) {
  return mesh.gloss.empty() && anyGloss(materials);
}

void lightVertices(const DisplayMesh& mesh, const relight::Planes& lux, std::span<vec3> out) {
  parallelFor(mesh.vertexCount(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      vec3 sum(0.0F);
      for (std::uint32_t k = mesh.first[v]; k < mesh.first[v + 1]; ++k) {
        const std::uint32_t slot = mesh.slots[k];
        sum += mesh.weights[k] * vec3(lux[0][slot], lux[1][slot], lux[2][slot]);
      }
      out[v] = glm::max(sum, vec3(0.0F));
    }
  });
}

std::vector<float> withoutSpecks(const DisplayMesh& mesh, std::span<const vec3> lux,
                                 std::span<const double> levels) {
  if (levels.empty() || mesh.neighbours == nullptr) return {};
  std::vector<float> values(lux.size());
  for (std::size_t v = 0; v < lux.size(); ++v) values[v] = color::luminance(lux[v]);
  std::vector<float> shift;
  for (const auto& speck : design::findSpecks(values, *mesh.neighbours, levels)) {
    if (shift.empty()) shift.assign(lux.size(), 0.0F);
    shift[speck.point] = speck.value - values[speck.point];
  }
  return shift;
}

}  // namespace soffit::ui
