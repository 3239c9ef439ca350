// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/light/luminaire.h"
#include "core/relight/lighting.h"
#include "core/scene/material.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

/// Rooms for the tests of the engine.
namespace soffit::relight::testing {

inline void addQuad(geometry::Mesh& mesh, const vec3& a, const vec3& b, const vec3& c, const vec3& d,
                    std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
  for (const uvec3 t : {uvec3(0, 1, 2), uvec3(0, 2, 3)}) {
    mesh.triangles.push_back(t + first);
    mesh.material_of.push_back(material);
    mesh.object_of.push_back(0);
  }
}

/// A box; fronts outward, or inward for a room. Materials: floor and ceiling and walls alike.
inline void addBox(geometry::Mesh& mesh, const vec3& lo, const vec3& hi, bool inward, std::uint32_t material) {
  const auto corner = [&](int x, int y, int z) { return vec3(x ? hi.x : lo.x, y ? hi.y : lo.y, z ? hi.z : lo.z); };
  const int faces[6][4][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                              {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}},
                              {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}};
  for (const auto& f : faces) {
    const vec3 a = corner(f[0][0], f[0][1], f[0][2]);
    const vec3 b = corner(f[1][0], f[1][1], f[1][2]);
    const vec3 c = corner(f[2][0], f[2][1], f[2][2]);
    const vec3 d = corner(f[3][0], f[3][1], f[3][2]);
    if (inward) {
      addQuad(mesh, d, c, b, a, material);
    } else {
      addQuad(mesh, a, b, c, d, material);
    }
  }
}

inline std::shared_ptr<geometry::Mesh> emptyMesh() {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->materials = {"m"};
  mesh->objects = {"o"};
  return mesh;
}

/// Turns and shifts a mesh about the origin.
inline void transform(geometry::Mesh& mesh, const dmat3& turn, const dvec3& shift) {
  for (vec3& p : mesh.positions) p = vec3(turn * dvec3(p) + shift);
}

inline transfer::BakeSettings quickSettings() {
  transfer::BakeSettings s;
  s.texels = 4000;
  s.trainings = 32;
  s.field_rays = 16;
  s.list_rays = 32;
  s.max_rank = 24;
  s.tolerance = 0.01;
  return s;
}

/// For comparing two bakes of one room: less noise.
inline transfer::BakeSettings fineSettings() {
  transfer::BakeSettings s = quickSettings();
  s.texels = 7000;
  return s;
}

inline std::shared_ptr<const Solver> solverFor(const std::shared_ptr<const geometry::Mesh>& mesh,
                                               const std::vector<dvec3>& reflectances,
                                               const transfer::BakeSettings& settings = quickSettings(),
                                               const std::vector<vec3>& inside = {}) {
  const auto scene = transfer::makeStaticScene(mesh, inside);
  const auto operators = transfer::bake(*scene, settings, {}, {});
  EXPECT_TRUE(operators.ok());
  std::vector<scene::Material> materials;
  for (const dvec3& rho : reflectances) {
    scene::Material m;
    m.diffuse = rho;
    materials.push_back(m);
  }
  return std::make_shared<const Solver>(scene, *operators, materials);
}

inline light::Luminaire panel(const dvec3& position, double size = 0.6, double flux = 1000.0) {
  light::Luminaire l;
  l.name = "Panel";
  l.shape = light::Rectangle{size, size};
  l.position = position;
  l.flux = flux;
  return l;
}

inline double luminance(const Planes& planes, std::size_t slot) {
  return 0.2126390058715104 * static_cast<double>(planes[0][slot]) +
         0.7151686787677560 * static_cast<double>(planes[1][slot]) +
         0.0721923153607336 * static_cast<double>(planes[2][slot]);
}

}  // namespace soffit::relight::testing
