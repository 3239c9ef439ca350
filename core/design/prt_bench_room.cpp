// SPDX-License-Identifier: MIT
#include "core/design/prt_bench_room.h"

#include "core/geometry/shapes.h"

#include <string>
#include <utility>

namespace soffit::design {
namespace {

struct Room {
  geometry::Mesh mesh;
  std::vector<scene::Material> materials;

  void add(const geometry::Mesh& part, const vec3& reflectance) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto number = static_cast<std::uint32_t>(materials.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    for (const uvec3& t : part.triangles) {
      mesh.triangles.push_back(t + first);
      mesh.material_of.push_back(number);
      mesh.object_of.push_back(number);
    }
    mesh.materials.push_back("m" + std::to_string(number));
    mesh.objects.push_back("part " + std::to_string(number));
    materials.emplace_back();
    materials.back().diffuse = dvec3(reflectance);
  }

  /// A rectangle from `corner` along u and v, front toward u x v.
  void addFlat(const vec3& corner, const vec3& u, const vec3& v, const vec3& rho, int cells) {
    geometry::Mesh part;
    const vec3 n = glm::normalize(glm::cross(u, v));
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const auto at = [cells](int k) {
          return static_cast<float>(k) / static_cast<float>(cells);
        };
        part.positions.push_back(corner + at(i) * u + at(j) * v);
        part.normals.push_back(n);
      }
    }
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      for (std::uint32_t i = 0; i + 1 < row; ++i) {
        const std::uint32_t a = j * row + i;
        part.triangles.push_back({a, a + 1, a + row + 1});
        part.triangles.push_back({a, a + row + 1, a + row});
      }
    }
    add(part, rho);
  }
};

}  // namespace

std::shared_ptr<const prt::Surfaces> prtBenchRoom(int cells) {
  const vec3 white(0.7F);
  const vec3 x(6, 0, 0), y(0, 5, 0), z(0, 0, 3);
  Room room;
  room.addFlat(vec3(0), x, y, {0.5F, 0.45F, 0.4F}, cells);
  room.addFlat(vec3(0), y, z, {0.7F, 0.15F, 0.1F}, cells);
  room.addFlat(x, z, y, white, cells);
  room.addFlat(vec3(0), z, x, white, cells);
  room.addFlat(y, x, z, white, cells);
  // The ceiling round a hole from (2, 1.5) to (4, 3).
  room.addFlat(z, vec3(0, 1.5F, 0), x, white, cells);
  room.addFlat(z + vec3(0, 3, 0), vec3(0, 2, 0), x, white, cells);
  room.addFlat(z + vec3(0, 1.5F, 0), vec3(0, 1.5F, 0), vec3(2, 0, 0), white, cells);
  room.addFlat(z + vec3(4, 1.5F, 0), vec3(0, 1.5F, 0), vec3(2, 0, 0), white, cells);
  room.add(geometry::makeBox({1, 2, 0.05F}, {2.5F, 3, 0.75F}), {0.3F, 0.4F, 0.5F});
  room.add(geometry::makeSphere({4.2F, 2, 0.8F}, 0.5F, 12), white);
  prt::Surfaces surfaces = *prt::makeSurfaces(
      std::make_shared<const geometry::Mesh>(std::move(room.mesh)), std::move(room.materials));
  // The shell's outside sees the whole sky and would hide the errors of the inside.
  for (std::uint8_t& sides : surfaces.sides) sides &= transfer::kFront;
  return std::make_shared<const prt::Surfaces>(std::move(surfaces));
}

}  // namespace soffit::design
