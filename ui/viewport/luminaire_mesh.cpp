// SPDX-License-Identifier: MIT
#include "ui/viewport/luminaire_mesh.h"

#include "core/geometry/shapes.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace soffit::ui {
namespace {

constexpr int kColumns = 32;
constexpr int kBands = 16;
constexpr float kPointCross = 0.06F;  // m
/// Edges of a mesh show where its faces meet at more than 30 degrees.
constexpr double kCreaseCosine = 0.866;

/// A corner with the normal of the surface that it stands for.
struct Corner {
  dvec3 position;
  dvec3 normal;
};

std::vector<Corner> diskCorners(const light::Emitter& e) {
  std::vector<Corner> out;
  const dvec3 x = e.world_from_light[0];
  const dvec3 y = glm::cross(e.normal, x);
  const auto rim = [&](int i) {
    const double phi = 2.0 * kPi * i / kColumns;
    return e.position + e.radius * (std::cos(phi) * x + std::sin(phi) * y);
  };
  for (int i = 0; i < kColumns; ++i) {
    for (const dvec3& p : {e.position, rim(i), rim(i + 1)}) out.push_back({p, e.normal});
  }
  return out;
}

std::vector<Corner> planarCorners(const light::Emitter& e) {
  if (e.disk) return diskCorners(e);
  std::vector<Corner> out;
  for (const uvec3& t : e.outline_triangles) {
    for (int k = 0; k < 3; ++k) out.push_back({e.outline[t[k]], e.normal});
  }
  return out;
}

std::vector<Corner> shapeCorners(const geometry::Mesh& mesh, const light::Emitter& e) {
  std::vector<Corner> out;
  for (const uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      out.push_back({e.position + e.world_from_light * dvec3(mesh.positions[t[k]]),
                     glm::normalize(e.world_from_light * dvec3(mesh.normals[t[k]]))});
    }
  }
  return out;
}

std::vector<Corner> meshCorners(const light::Emitter& e) {
  std::vector<Corner> out;
  for (std::size_t i = 0; i < e.corners.size(); ++i) {
    out.push_back({e.corners[i], e.triangle_normals[i / 3]});
  }
  return out;
}

std::vector<Corner> cornersOf(const light::Emitter& e) {
  const auto radius = static_cast<float>(e.radius);
  switch (e.kind) {
    case light::EmitterKind::planar:
      return planarCorners(e);
    case light::EmitterKind::sphere:
      return shapeCorners(geometry::makeSphere(vec3(0.0F), radius, kBands), e);
    case light::EmitterKind::tube:
      return shapeCorners(
          geometry::makeTube(static_cast<float>(2.0 * e.half_length), radius, kColumns, false), e);
    case light::EmitterKind::mesh:
      return meshCorners(e);
    case light::EmitterKind::point:
      break;
  }
  return {};
}

void addLoop(std::vector<vec3>& lines, const std::vector<dvec3>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    lines.emplace_back(corners[i]);
    lines.emplace_back(corners[(i + 1) % corners.size()]);
  }
}

std::vector<dvec3> circle(const dvec3& center, const dvec3& x, const dvec3& y, double radius) {
  std::vector<dvec3> out;
  for (int i = 0; i < kColumns; ++i) {
    const double phi = 2.0 * kPi * i / kColumns;
    out.push_back(center + radius * (std::cos(phi) * x + std::sin(phi) * y));
  }
  return out;
}

/// Edges with one triangle, or between faces that differ.
std::vector<vec3> creases(const light::Emitter& e) {
  using Key = std::array<float, 6>;
  std::map<Key, std::vector<std::size_t>> faces;
  const auto key = [](const vec3& a, const vec3& b) { return Key{a.x, a.y, a.z, b.x, b.y, b.z}; };
  for (std::size_t t = 0; t < e.triangle_normals.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const vec3 a(e.corners[3 * t + k]);
      const vec3 b(e.corners[3 * t + (k + 1) % 3]);
      faces[std::min(key(a, b), key(b, a))].push_back(t);
    }
  }
  std::vector<vec3> lines;
  for (const auto& [edge, owners] : faces) {
    const bool smooth =
        owners.size() == 2 &&
        glm::dot(e.triangle_normals[owners[0]], e.triangle_normals[owners[1]]) > kCreaseCosine;
    if (smooth) continue;
    lines.emplace_back(edge[0], edge[1], edge[2]);
    lines.emplace_back(edge[3], edge[4], edge[5]);
  }
  return lines;
}

}  // namespace

LuminaireMesh makeLuminaireMesh(const EmitterSet& set, const vec3& eye,
                                const std::vector<bool>& left_out) {
  LuminaireMesh mesh;
  for (std::size_t i = 0; i < set.emitters().size(); ++i) {
    if (i < left_out.size() && left_out[i]) continue;
    const light::Emitter& e = set.emitters()[i];
    const std::vector<Corner> corners = cornersOf(e);
    const auto toward = [&](const Corner& corner, const dvec3& normal) {
      const vec3 to_eye = glm::normalize(eye - vec3(corner.position));
      return set.radiance(i).toward(e, vec3(normal), to_eye);
    };
    for (const Corner& c : corners) {
      mesh.triangles.push_back({vec3(c.position), toward(c, c.normal)});
    }
    const bool has_back =
        e.kind == light::EmitterKind::planar && (e.twoSided() || e.casts_shadow || e.gain <= 0.0);
    if (!has_back) continue;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
      for (const std::size_t k : {t, t + 2, t + 1}) {
        mesh.triangles.push_back(
            {vec3(corners[k].position), toward(corners[k], -corners[k].normal)});
      }
    }
  }
  return mesh;
}

std::vector<vec3> outlineOf(const light::Emitter& e) {
  std::vector<vec3> lines;
  const dmat3& frame = e.world_from_light;
  switch (e.kind) {
    case light::EmitterKind::point:
      for (int axis = 0; axis < 3; ++axis) {
        vec3 step(0.0F);
        step[axis] = kPointCross;
        lines.push_back(vec3(e.position) - step);
        lines.push_back(vec3(e.position) + step);
      }
      break;
    case light::EmitterKind::planar:
      addLoop(lines, e.disk ? circle(e.position, frame[0], frame[1], e.radius) : e.outline);
      break;
    case light::EmitterKind::sphere:
      for (int axis = 0; axis < 3; ++axis) {
        addLoop(lines, circle(e.position, frame[axis], frame[(axis + 1) % 3], e.radius));
      }
      break;
    case light::EmitterKind::tube:
      for (const double end : {-1.0, 1.0}) {
        addLoop(lines,
                circle(e.position + end * e.half_length * e.axis, frame[1], frame[2], e.radius));
      }
      for (const dvec3& side : {frame[1], -frame[1], frame[2], -frame[2]}) {
        lines.emplace_back(e.position - e.half_length * e.axis + e.radius * side);
        lines.emplace_back(e.position + e.half_length * e.axis + e.radius * side);
      }
      break;
    case light::EmitterKind::mesh:
      lines = creases(e);
      break;
  }
  return lines;
}

}  // namespace soffit::ui
