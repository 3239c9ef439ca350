// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/engine.h"
#include "core/relight/solver.h"
#include "tests/core/relight/rooms.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>

/// A room with a window, baked once for all tests of a program.
namespace soffit::relight::testing {

inline constexpr double kWidth = 1.8;   // m, of the window
inline constexpr double kHeight = 1.4;  // m
inline constexpr double kSill = 0.9;    // m

/// A room of 4 x 5 x 3 m with a window in the wall at y = 0, 20 cm deep with a reveal, and a desk.
/// Material 0: walls, 1: glass, 2: floor, 3: ceiling.
inline scene::Scene windowRoom(bool glazed) {
  scene::Scene scene;
  auto mesh = emptyMesh();
  mesh->materials = {"wall", "glass", "floor", "ceiling"};
  const float x0 = 1.1F;
  const float x1 = x0 + static_cast<float>(kWidth);
  const float z0 = static_cast<float>(kSill);
  const float z1 = z0 + static_cast<float>(kHeight);
  const auto quad = [&](vec3 a, vec3 b, vec3 c, vec3 d, std::uint32_t m) {
    addQuad(*mesh, a, b, c, d, m);
  };
  // Inward: floor, ceiling, three walls.
  quad({0, 0, 0}, {4, 0, 0}, {4, 5, 0}, {0, 5, 0}, 2);
  quad({0, 0, 3}, {0, 5, 3}, {4, 5, 3}, {4, 0, 3}, 3);
  quad({0, 0, 0}, {0, 5, 0}, {0, 5, 3}, {0, 0, 3}, 0);
  quad({4, 0, 0}, {4, 0, 3}, {4, 5, 3}, {4, 5, 0}, 0);
  quad({0, 5, 0}, {4, 5, 0}, {4, 5, 3}, {0, 5, 3}, 0);
  // The wall with the hole, four pieces and the reveal.
  quad({0, 0, 0}, {0, 0, z0}, {4, 0, z0}, {4, 0, 0}, 0);
  quad({0, 0, z1}, {0, 0, 3}, {4, 0, 3}, {4, 0, z1}, 0);
  quad({0, 0, z0}, {0, 0, z1}, {x0, 0, z1}, {x0, 0, z0}, 0);
  quad({x1, 0, z0}, {x1, 0, z1}, {4, 0, z1}, {4, 0, z0}, 0);
  const float out = -0.2F;
  quad({x0, 0, z0}, {x0, out, z0}, {x1, out, z0}, {x1, 0, z0}, 0);
  quad({x0, 0, z1}, {x1, 0, z1}, {x1, out, z1}, {x0, out, z1}, 0);
  quad({x0, 0, z0}, {x0, 0, z1}, {x0, out, z1}, {x0, out, z0}, 0);
  quad({x1, 0, z0}, {x1, out, z0}, {x1, out, z1}, {x1, 0, z1}, 0);
  if (glazed) quad({x0, out, z0}, {x1, out, z0}, {x1, out, z1}, {x0, out, z1}, 1);
  addBox(*mesh, {0.5F, 1.8F, 0.68F}, {2.1F, 2.6F, 0.72F}, false, 0);
  scene.mesh = mesh;
  scene.materials.resize(4);
  scene.materials[0].diffuse = dvec3(0.6);
  scene.materials[1].glass = scene::Glass{1.52, 0.88};
  scene.materials[2].diffuse = dvec3(0.3);
  scene.materials[3].diffuse = dvec3(0.8);
  for (std::size_t i = 0; i < 4; ++i) scene.materials[i].name = mesh->materials[i];
  return scene;
}

inline std::shared_ptr<const Solver> solverOf(const scene::Scene& scene) {
  const auto fixed = makeStaticScene(scene);
  auto operators = transfer::bake(*fixed, quickSettings(), {}, {});
  EXPECT_TRUE(operators.ok());
  return std::make_shared<const Solver>(fixed, *operators, scene.materials);
}

/// One bake for all tests of a room.
inline std::shared_ptr<const Solver> windowSolver(bool glazed) {
  static std::map<bool, std::shared_ptr<const Solver>> known;
  auto& solver = known[glazed];
  if (solver == nullptr) solver = solverOf(windowRoom(glazed));
  return solver;
}

}  // namespace soffit::relight::testing
