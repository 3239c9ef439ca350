// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/engine.h"
#include "core/scene/scene.h"
#include "tests/core/relight/rooms.h"

#include <gtest/gtest.h>

#include <memory>

/// Small rooms for the tests of design.
namespace soffit::design::testing {

/// A room of 4 x 5 x 3 m, gray of 0.5, with a block, a panel below the ceiling and a work plane.
inline scene::Scene blockRoom() {
  auto mesh = relight::testing::emptyMesh();
  relight::testing::addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  relight::testing::addBox(*mesh, {1, 1, 0.3F}, {2, 2.2F, 1.3F}, false, 0);
  scene::Scene scene;
  scene.mesh = mesh;
  scene.materials.resize(1);
  scene.materials[0].name = "m";
  scene.materials[0].diffuse = dvec3(0.5);
  scene.luminaires = {relight::testing::panel({2.0, 2.5, 2.9})};
  scene::WorkPlane plane;
  plane.name = "Table";
  plane.origin = {2.5, 1.0, 0.8};
  plane.u = {1.0, 0.0, 0.0};
  plane.v = {0.0, 3.0, 0.0};
  plane.nu = 2;
  plane.nv = 3;
  scene.work_planes = {plane};
  return scene;
}

/// Two rooms of 3 x 4 x 3 m side by side in x, joined by a doorway 0.8 m wide and 2 m high, the
/// light in the left one, a work plane in each.
inline scene::Scene twoRooms() {
  using relight::testing::addBox;
  using relight::testing::addQuad;
  scene::Scene scene = blockRoom();
  auto mesh = relight::testing::emptyMesh();
  addBox(*mesh, {0, 0, 0}, {6, 4, 3}, true, 0);
  addQuad(*mesh, {3, 0, 0}, {3, 1.6F, 0}, {3, 1.6F, 3}, {3, 0, 3}, 0);
  addQuad(*mesh, {3, 2.4F, 0}, {3, 4, 0}, {3, 4, 3}, {3, 2.4F, 3}, 0);
  addQuad(*mesh, {3, 1.6F, 2}, {3, 2.4F, 2}, {3, 2.4F, 3}, {3, 1.6F, 3}, 0);
  scene.mesh = mesh;
  scene.luminaires = {relight::testing::panel({1.5, 2.0, 2.9})};
  scene.work_planes.resize(2, scene.work_planes[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    scene.work_planes[i].name = i == 0 ? "Left" : "Right";
    scene.work_planes[i].origin = {0.5 + 3.0 * static_cast<double>(i), 0.5, 0.8};
    scene.work_planes[i].u = {2.0, 0.0, 0.0};
    scene.work_planes[i].v = {0.0, 3.0, 0.0};
    scene.work_planes[i].nu = 3;
  }
  return scene;
}

inline std::shared_ptr<const relight::Solver> solverOf(const scene::Scene& scene,
                                                       int texels = 2000) {
  relight::QualitySettings quality;
  quality.bake = relight::testing::quickSettings();
  quality.bake.texels = texels;
  relight::EngineReport report;
  const auto solver = relight::makeSolver(scene, quality, false, {}, report);
  EXPECT_TRUE(solver.ok());
  return *solver;
}

}  // namespace soffit::design::testing
