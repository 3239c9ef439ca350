// SPDX-License-Identifier: MIT
#include "core/geometry/cleaning.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/geometry/corner_normals.h"
#include "core/geometry/duplicates.h"
#include "core/geometry/frame_origin.h"
#include "core/geometry/orientation.h"
#include "core/geometry/weld.h"
#include "core/math/rng.h"

namespace soffit::geometry {
namespace {

// The work in hand: `kept` lists raw triangles, `corners` their welded points, side by side.
struct Work {
  const RawMesh& raw;
  dvec3 origin{0.0};
  std::vector<vec3> points;         // per raw vertex, relative to origin
  std::vector<std::uint32_t> weld;  // per raw vertex, the first at its point
  std::vector<std::uint32_t> kept;
  std::vector<uvec3> corners;
  std::vector<char> turned;  // corners run against the raw triangle: y and z change places
  CleaningReport report;

  // The raw vertex at corner k of the i-th kept triangle.
  [[nodiscard]] std::uint32_t vertex(std::size_t i, int k) const {
    return raw.triangles[kept[i]][turned[i] != 0 && k > 0 ? 3 - k : k];
  }

  // Keeps what `wanted(position in kept)` asks for, in order; returns how many went.
  template <class Predicate>
  std::size_t keepIf(const Predicate& wanted) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!wanted(i)) continue;
      kept[out] = kept[i];
      turned[out] = turned[i];
      corners[out++] = corners[i];
    }
    const std::size_t gone = kept.size() - out;
    kept.resize(out);
    corners.resize(out);
    turned.resize(out);
    return gone;
  }
};

void dropNonFinite(Work& work) {
  const RawMesh& raw = work.raw;
  // Beyond this, areas and volumes overflow in single precision.
  constexpr double kLimit = 1e12;
  const auto good = [&](std::uint32_t v) {
    assert(v < raw.positions.size());
    const dvec3 a = glm::abs(raw.positions[v]);
    return a.x < kLimit && a.y < kLimit && a.z < kLimit;  // false for NaN
  };
  for (std::uint32_t i = 0; i < raw.triangles.size(); ++i) {
    const uvec3 t = raw.triangles[i];
    if (good(t.x) && good(t.y) && good(t.z)) work.kept.push_back(i);
  }
  work.report.non_finite = raw.triangles.size() - work.kept.size();
}

// Moves to the mesh's frame and welds. Vertices that no triangle uses take part in nothing.
void weldCorners(Work& work) {
  const RawMesh& raw = work.raw;
  std::vector<char> used(raw.positions.size(), 0);
  DoubleBox box;
  for (const std::uint32_t i : work.kept) {
    for (int k = 0; k < 3; ++k) {
      used[raw.triangles[i][k]] = 1;
      box.add(raw.positions[raw.triangles[i][k]]);
    }
  }
  work.origin = chooseOrigin(box);
  work.points.assign(raw.positions.size(), vec3(std::numeric_limits<float>::quiet_NaN()));
  Box bounds;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    work.points[v] = vec3(raw.positions[v] - work.origin);
    bounds.add(work.points[v]);
  }
  work.weld = weldPositions(work.points, weldTolerance(bounds));
  for (const std::uint32_t i : work.kept) {
    const uvec3 t = raw.triangles[i];
    work.corners.emplace_back(work.weld[t.x], work.weld[t.y], work.weld[t.z]);
  }
  work.turned.assign(work.kept.size(), 0);
  const double tolerance = weldTolerance(bounds);
  work.report.degenerate = work.keepIf([&](std::size_t i) {
    const uvec3 c = work.corners[i];
    const dvec3 a(work.points[c.x]);
    const dvec3 b(work.points[c.y]);
    const dvec3 d(work.points[c.z]);
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, d), glm::distance(d, a)});
    const double twice_area = glm::length(glm::cross(b - a, d - a));
    return twice_area > tolerance * longest;  // height above the longest side
  });
}

void agreeOnFronts(Work& work) {
  work.turned = findTurned(work.points, work.corners);
  for (std::size_t i = 0; i < work.kept.size(); ++i) {
    if (work.turned[i] == 0) continue;
    std::swap(work.corners[i].y, work.corners[i].z);
    ++work.report.turned;
  }
}

void dropDuplicates(Work& work) {
  const std::vector<char> duplicate = markDuplicates(work.points, work.corners);
  work.report.duplicate = work.keepIf([&](std::size_t i) { return duplicate[i] == 0; });
}

vec3 givenNormal(const RawMesh& raw, std::uint32_t vertex) {
  if (raw.normals.empty()) return vec3(0.0F);
  const dvec3 n(raw.normals[vertex]);
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length) ? vec3(n / length) : vec3(0.0F);
}

// Negates the normals of a triangle that mostly point to its back.
void faceFront(const Work& work, std::size_t triangle, std::span<vec3> normals) {
  const uvec3 c = work.corners[triangle];
  const dvec3 a(work.points[c.x]);
  const dvec3 face = glm::cross(dvec3(work.points[c.y]) - a, dvec3(work.points[c.z]) - a);
  if (glm::dot(dvec3(normals[0]) + dvec3(normals[1]) + dvec3(normals[2]), face) >= 0.0) return;
  for (vec3& n : normals) n = -n;
}

// The normal of every corner: the file's, or made where that is missing.
std::vector<vec3> normalsOfCorners(Work& work, double crease_deg) {
  std::vector<vec3> normals(3 * work.kept.size());
  std::vector<char> lacks(work.kept.size(), 0);
  for (std::size_t i = 0; i < work.kept.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const vec3 n = givenNormal(work.raw, work.vertex(i, k));
      normals[3 * i + static_cast<std::size_t>(k)] = n;
      if (n == vec3(0.0F)) lacks[i] = 1;
    }
    faceFront(work, i, std::span(normals).subspan(3 * i, 3));
  }
  work.report.made_normals =
      static_cast<std::size_t>(std::count(lacks.begin(), lacks.end(), char{1}));
  if (work.report.made_normals == 0) return normals;
  std::vector<std::uint32_t> object_of;
  for (const std::uint32_t i : work.kept) object_of.push_back(work.raw.object_of[i]);
  const std::vector<vec3> made = cornerNormals({work.points, work.corners, object_of}, crease_deg);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == vec3(0.0F)) normals[i] = made[i];
  }
  return normals;
}

// Gives equal (point, normal, uv) triples one vertex.
class VertexTable {
 public:
  VertexTable(Mesh& mesh, std::size_t corners, bool with_uv)
      : mesh_(mesh), with_uv_(with_uv), slots_(std::bit_ceil(2 * corners + 1), kEmpty) {}

  std::uint32_t vertex(std::uint32_t point, const vec3& position, const vec3& normal,
                       const vec2& uv) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(point, normal, uv) & mask;
    for (; slots_[slot] != kEmpty; slot = (slot + 1) & mask) {
      const std::uint32_t v = slots_[slot];
      const bool same_uv = !with_uv_ || mesh_.uvs[v] == uv;
      if (point_[v] == point && mesh_.normals[v] == normal && same_uv) return v;
    }
    slots_[slot] = static_cast<std::uint32_t>(mesh_.positions.size());
    point_.push_back(point);
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    if (with_uv_) mesh_.uvs.push_back(uv);
    return slots_[slot];
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffffU;

  static std::uint64_t hash(std::uint32_t point, const vec3& n, const vec2& uv) {
    const auto word = [](float f) {
      return std::uint64_t{std::bit_cast<std::uint32_t>(f + 0.0F)};  // + 0: one zero
    };
    std::uint64_t h = mixBits(point | (word(n.x) << 32U));
    h = mixBits(h ^ (word(n.y) | (word(n.z) << 32U)));
    return mixBits(h ^ (word(uv.x) | (word(uv.y) << 32U)));
  }

  Mesh& mesh_;
  bool with_uv_;
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> point_;
};

Mesh assemble(const Work& work, std::span<const vec3> normals) {
  const RawMesh& raw = work.raw;
  Mesh mesh;
  mesh.origin = work.origin;
  mesh.materials = raw.materials;
  mesh.objects = raw.objects;
  VertexTable table(mesh, normals.size(), !raw.uvs.empty());
  for (std::size_t i = 0; i < work.kept.size(); ++i) {
    const std::uint32_t source = work.kept[i];
    uvec3 out{};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t point = work.corners[i][k];
      vec2 uv = raw.uvs.empty() ? vec2(0.0F) : raw.uvs[work.vertex(i, k)];
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = vec2(0.0F);
      out[k] =
          table.vertex(point, work.points[point], normals[3 * i + static_cast<std::size_t>(k)], uv);
    }
    mesh.triangles.push_back(out);
    mesh.material_of.push_back(raw.material_of[source]);
    mesh.object_of.push_back(raw.object_of[source]);
  }
  return mesh;
}

}  // namespace

CleanedMesh cleanMesh(const RawMesh& raw, double crease_deg) {
  assert(raw.material_of.size() == raw.triangles.size());
  assert(raw.object_of.size() == raw.triangles.size());
  Work work{.raw = raw};
  work.report.triangles_in = raw.triangles.size();
  work.report.vertices_in = raw.positions.size();
  dropNonFinite(work);
  weldCorners(work);
  agreeOnFronts(work);
  dropDuplicates(work);
  const std::vector<vec3> normals = normalsOfCorners(work, crease_deg);
  CleanedMesh out{.mesh = assemble(work, normals), .report = work.report};
  out.report.triangles_out = out.mesh.triangles.size();
  out.report.vertices_out = out.mesh.positions.size();
  return out;
}

}  // namespace soffit::geometry
