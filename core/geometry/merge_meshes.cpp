// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "core/geometry/cleaning.h"
#include "core/geometry/frame_origin.h"

namespace soffit::geometry {
namespace {

dvec3 commonOrigin(const std::vector<Mesh>& meshes) {
  DoubleBox box;
  for (const Mesh& mesh : meshes) {
    for (const vec3& p : mesh.positions) box.add(mesh.origin + dvec3(p));
  }
  return chooseOrigin(box);
}

void appendVertices(const Mesh& mesh, bool with_uv, Mesh& out) {
  const dvec3 shift = mesh.origin - out.origin;
  for (const vec3& p : mesh.positions) {
    out.positions.push_back(shift == dvec3(0.0) ? p : vec3(dvec3(p) + shift));
  }
  out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
  if (!with_uv) return;
  out.uvs.insert(out.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
  out.uvs.resize(out.positions.size(), vec2(0.0F));
}

}  // namespace

Mesh mergeMeshes(const std::vector<Mesh>& meshes) {
  Mesh out;
  out.origin = commonOrigin(meshes);
  const auto any = [&](auto test) { return std::any_of(meshes.begin(), meshes.end(), test); };
  const bool with_uv = any([](const Mesh& m) { return !m.uvs.empty(); });
  std::map<std::string, std::uint32_t> material_index;
  for (const Mesh& mesh : meshes) {
    std::vector<std::uint32_t> material;
    for (const std::string& name : mesh.materials) {
      const auto next = static_cast<std::uint32_t>(out.materials.size());
      const auto [at, added] = material_index.try_emplace(name, next);
      if (added) out.materials.push_back(name);
      material.push_back(at->second);
    }
    const auto first_vertex = static_cast<std::uint32_t>(out.positions.size());
    const auto first_object = static_cast<std::uint32_t>(out.objects.size());
    appendVertices(mesh, with_uv, out);
    for (const uvec3& t : mesh.triangles) out.triangles.push_back(t + first_vertex);
    for (const std::uint32_t m : mesh.material_of) out.material_of.push_back(material[m]);
    for (const std::uint32_t o : mesh.object_of) out.object_of.push_back(first_object + o);
    out.objects.insert(out.objects.end(), mesh.objects.begin(), mesh.objects.end());
  }
  return out;
}

}  // namespace soffit::geometry
