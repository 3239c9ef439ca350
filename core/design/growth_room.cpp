// SPDX-License-Identifier: MIT
#include "core/design/growth_room.h"

#include "core/geometry/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace soffit::design {
namespace {

constexpr vec3 kRoom(16.0F, 12.0F, 3.0F);
constexpr int kColumns = 8;
constexpr int kRows = 6;
constexpr double kFlux = 60000.0;  ///< lm, of all panels
constexpr std::array<const char*, 3> kNames{"walls", "plinths", "spheres"};
constexpr std::array kReflectances{0.7, 0.5, 0.3};

void add(const geometry::Mesh& part, std::uint32_t material, geometry::Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
  for (const uvec3& t : part.triangles) {
    mesh.triangles.push_back(t + first);
    mesh.material_of.push_back(material);
    mesh.object_of.push_back(material);
  }
}

/// Bands of a sphere of at least so many triangles.
int bandsFor(std::size_t triangles) {
  int bands = 2;
  while (geometry::makeSphere(vec3(0.0F), 1.0F, bands).triangleCount() < triangles) {
    bands = std::max(bands + 1, bands * 9 / 8);
  }
  return bands;
}

void addFurniture(std::size_t triangles, geometry::Mesh& mesh) {
  const std::size_t spheres = static_cast<std::size_t>(kColumns) * kRows;
  const std::size_t others = 12 * (spheres + 1);
  const int bands = bandsFor(triangles > others ? (triangles - others) / spheres : 0);
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const vec3 foot(kRoom.x * (static_cast<float>(i) + 0.5F) / kColumns,
                      kRoom.y * (static_cast<float>(j) + 0.5F) / kRows, 0.0F);
      add(geometry::makeBox(foot - vec3(0.4F, 0.3F, 0.0F), foot + vec3(0.4F, 0.3F, 0.75F)), 1,
          mesh);
      add(geometry::makeSphere(foot + vec3(0.0F, 0.0F, 1.1F), 0.3F, bands), 2, mesh);
    }
  }
}

}  // namespace

scene::Scene growthRoom(std::size_t triangles, std::size_t luminaires) {
  auto mesh = std::make_shared<geometry::Mesh>();
  for (const char* name : kNames) {
    mesh->materials.emplace_back(name);
    mesh->objects.emplace_back(name);
  }
  add(geometry::makeBox(vec3(0.0F), kRoom), 0, *mesh);
  addFurniture(triangles, *mesh);
  scene::Scene scene;
  scene.name = "growth";
  scene.mesh = std::move(mesh);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    scene.materials.emplace_back();
    scene.materials.back().name = kNames[i];
    scene.materials.back().diffuse = dvec3(kReflectances[i]);
  }
  const auto columns =
      static_cast<std::size_t>(std::ceil(std::sqrt(4.0 / 3.0 * static_cast<double>(luminaires))));
  const std::size_t rows = columns == 0 ? 0 : (luminaires + columns - 1) / columns;
  const double side = std::min(0.6, 0.6 * static_cast<double>(kRoom.x) /
                                        static_cast<double>(std::max<std::size_t>(columns, 1)));
  for (std::size_t i = 0; i < luminaires; ++i) {
    light::Luminaire panel;
    panel.name = fmt::format("Panel {}", i + 1);
    panel.shape = light::Rectangle{side, side};
    panel.position = {static_cast<double>(kRoom.x) * (static_cast<double>(i % columns) + 0.5) /
                          static_cast<double>(columns),
                      static_cast<double>(kRoom.y) * (static_cast<double>(i / columns) + 0.5) /
                          static_cast<double>(rows),
                      static_cast<double>(kRoom.z) - 0.01};
    panel.flux = kFlux / static_cast<double>(luminaires);
    scene.luminaires.push_back(std::move(panel));
  }
  return scene;
}

}  // namespace soffit::design
