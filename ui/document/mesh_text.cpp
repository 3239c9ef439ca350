// SPDX-License-Identifier: MIT
#include "ui/document/mesh_text.h"

#include "core/math/sampling.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace soffit::ui {
namespace {

using Place = std::array<float, 3>;

Place placeOf(const vec3& p) {
  return {p.x, p.y, p.z};
}

}  // namespace

std::string objText(const geometry::Mesh& mesh) {
  std::string text = "# metres, z up\n";
  for (const vec3& p : mesh.positions) {
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
  }
  for (const uvec3& t : mesh.triangles) {
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  }
  return text;
}

geometry::Mesh ringMesh(float outer, float inner, int columns) {
  geometry::Mesh mesh;
  for (int i = 0; i < columns; ++i) {
    const float phi =
        2.0F * static_cast<float>(kPi) * static_cast<float>(i) / static_cast<float>(columns);
    const vec3 way(std::cos(phi), std::sin(phi), 0.0F);
    mesh.positions.push_back(outer * way);
    mesh.positions.push_back(inner * way);
  }
  const auto n = static_cast<std::uint32_t>(columns);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, a + 1, b});
    mesh.triangles.push_back({b, a + 1, b + 1});
  }
  mesh.material_of.assign(mesh.triangles.size(), 0);
  mesh.materials = {"light"};
  return mesh;
}

geometry::Mesh liftedPart(const geometry::Mesh& building, std::span<const std::uint32_t> triangles,
                          bool flip, float lift, dvec3& middle) {
  geometry::Mesh part;
  std::map<Place, std::uint32_t> index;
  std::vector<vec3> normals;
  for (const std::uint32_t t : triangles) {
    uvec3 corners = building.triangles[t];
    if (flip) std::swap(corners.y, corners.z);
    const vec3& a = building.positions[corners.x];
    const vec3 cross =
        glm::cross(building.positions[corners.y] - a, building.positions[corners.z] - a);
    for (int k = 0; k < 3; ++k) {
      const vec3 p = building.positions[corners[k]];
      const auto [found, added] =
          index.try_emplace(placeOf(p), static_cast<std::uint32_t>(part.positions.size()));
      if (added) {
        part.positions.push_back(p);
        normals.emplace_back(0.0F);
      }
      corners[k] = found->second;
      const float length = glm::length(cross);
      if (length > 0.0F) normals[corners[k]] += cross / length;
    }
    part.triangles.push_back(corners);
  }
  const vec3 center = part.bounds().center();
  middle = building.origin + dvec3(center);
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    const float length = glm::length(normals[i]);
    const vec3 out = length > 1e-6F ? normals[i] / length : vec3(0.0F);
    part.positions[i] += lift * out - center;
  }
  part.material_of.assign(part.triangles.size(), 0);
  part.materials = {"light"};
  return part;
}

std::vector<std::uint32_t> partAround(const geometry::Mesh& building, std::uint32_t triangle) {
  const auto kindOf = [&](std::size_t t) {
    return std::array<std::uint32_t, 2>{
        building.object_of.empty() ? 0U : building.object_of[t],
        building.material_of.empty() ? 0U : building.material_of[t]};
  };
  const auto kind = kindOf(triangle);
  std::map<Place, std::vector<std::uint32_t>> users;
  for (std::uint32_t t = 0; t < building.triangles.size(); ++t) {
    if (kindOf(t) != kind) continue;
    for (int k = 0; k < 3; ++k) {
      users[placeOf(building.positions[building.triangles[t][k]])].push_back(t);
    }
  }
  std::vector<bool> taken(building.triangles.size(), false);
  std::vector<std::uint32_t> part{triangle};
  taken[triangle] = true;
  for (std::size_t next = 0; next < part.size(); ++next) {
    for (int k = 0; k < 3; ++k) {
      auto& around = users[placeOf(building.positions[building.triangles[part[next]][k]])];
      for (const std::uint32_t t : around) {
        if (taken[t]) continue;
        taken[t] = true;
        part.push_back(t);
      }
      around.clear();
    }
  }
  return part;
}

}  // namespace soffit::ui
