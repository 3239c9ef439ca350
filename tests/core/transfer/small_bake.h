// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/shapes.h"
#include "core/transfer/cache_file.h"
#include "core/transfer/operators.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

/// A room small enough to be baked in each test program, and its bake as bytes.
namespace soffit::transfer::testing {

inline constexpr std::string_view kKey = "0123456789abcdef0123456789abcdef";

inline BakeSettings smallSettings() {
  return {.texels = 500, .trainings = 8, .field_rays = 8, .list_rays = 8};
}

inline void append(geometry::Mesh& mesh, const geometry::Mesh& part, std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const uvec3& t : part.triangles) mesh.triangles.push_back(t + first);
  mesh.material_of.resize(mesh.triangles.size(), material);
}

/// A room of 4 x 3 x 2.5 m with a block, and a die that is smaller than a texel.
inline geometry::Mesh roomMesh() {
  geometry::Mesh mesh;
  append(mesh, geometry::makeBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1, 1, 0.5F}, {2, 1.5F, 1.5F}), 1);
  append(mesh, geometry::makeBox({3, 2, 1}, {3.01F, 2.01F, 1.01F}), 2);
  for (const vec3& p : mesh.positions) mesh.uvs.emplace_back(p.x + p.z, p.y - 0.5F * p.z);
  return mesh;
}

inline std::shared_ptr<const StaticScene> sceneOf(geometry::Mesh mesh) {
  return makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), {});
}

/// The room's bake, made once.
inline const Operators& smallBake() {
  static const auto baked = bake(*sceneOf(roomMesh()), smallSettings(), {}, {});
  return **baked;
}

inline std::string stored(const Operators& operators, std::string_view key = kKey) {
  std::string out;
  EXPECT_TRUE(writeOperators(operators, key, [&](std::span<const std::byte> bytes) {
    out.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return true;
  }));
  return out;
}

}  // namespace soffit::transfer::testing
