// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <memory>

namespace soffit::scene {

/// One triangle, two materials, two luminaires, a layout, a camera and a work plane; sound.
inline Scene exampleScene() {
  Scene scene;
  scene.name = "Example";
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}};
  mesh.material_of = {0};
  mesh.object_of = {0};
  mesh.materials = {"wall", "floor"};
  mesh.objects = {"part"};
  scene.mesh = std::make_shared<const geometry::Mesh>(mesh);
  scene.materials.resize(2);
  scene.materials[0].name = "wall";
  scene.materials[1].name = "floor";
  light::Luminaire panel;
  panel.name = "Panel";
  panel.flux = 3000.0;
  panel.position = {1, 2, 3};
  light::Luminaire lamp;
  lamp.name = "Lamp";
  lamp.shape = light::Sphere{0.1};
  lamp.flux = 800.0;
  scene.luminaires = {panel, lamp};
  Layout evening;
  evening.name = "Evening";
  evening.edits["Panel"].dimming = 0.25;
  evening.edits["Candle"].shape = light::PointShape{};
  evening.edits["Candle"].flux = 12.0;
  scene.layouts = {Layout{"Base", {}}, evening};
  scene.cameras = {{"Entrance", {0, 0, 1.6}, {1, 1, 1.5}, 50.0}};
  scene.work_planes = {{"Desks", {0, 0, 0.8}, {4, 0, 0}, {0, 2, 0}, 4, 2, "office"}};
  return scene;
}

}  // namespace soffit::scene
