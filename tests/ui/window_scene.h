// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/io/project/project.h"

#include <memory>
#include <utility>

/// A small room with a glazed window and a sky, for tests of daylight in the application.
namespace soffit::ui {

/// 4 x 5 x 3 m; the window, 2 x 1.5 m, is in the middle of the wall at y = 0, its sill at 1 m.
inline io::Project windowProject() {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->materials = {"wall", "pane"};
  mesh->objects = {"room"};
  const auto quad = [&](vec3 a, vec3 b, vec3 c, vec3 d, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    mesh->positions.insert(mesh->positions.end(), {a, b, c, d});
    for (const uvec3 t : {uvec3(0, 1, 2), uvec3(0, 2, 3)}) {
      mesh->triangles.push_back(t + first);
      mesh->material_of.push_back(material);
      mesh->object_of.push_back(0);
    }
  };
  quad({0, 0, 0}, {4, 0, 0}, {4, 5, 0}, {0, 5, 0}, 0);
  quad({0, 0, 3}, {0, 5, 3}, {4, 5, 3}, {4, 0, 3}, 0);
  quad({0, 0, 0}, {0, 5, 0}, {0, 5, 3}, {0, 0, 3}, 0);
  quad({4, 0, 0}, {4, 0, 3}, {4, 5, 3}, {4, 5, 0}, 0);
  quad({0, 5, 0}, {4, 5, 0}, {4, 5, 3}, {0, 5, 3}, 0);
  quad({0, 0, 0}, {0, 0, 1}, {4, 0, 1}, {4, 0, 0}, 0);
  quad({0, 0, 2.5F}, {0, 0, 3}, {4, 0, 3}, {4, 0, 2.5F}, 0);
  quad({0, 0, 1}, {0, 0, 2.5F}, {1, 0, 2.5F}, {1, 0, 1}, 0);
  quad({3, 0, 1}, {3, 0, 2.5F}, {4, 0, 2.5F}, {4, 0, 1}, 0);
  quad({1, 0, 1}, {1, 0, 2.5F}, {3, 0, 2.5F}, {3, 0, 1}, 1);
  io::Project project;
  scene::Scene& scene = project.scene;
  scene.mesh = mesh;
  scene.materials.resize(2);
  scene.materials[0].name = "wall";
  scene.materials[0].diffuse = dvec3(0.5);
  scene.materials[1].name = "pane";
  scene.materials[1].glass = scene::Glass{1.52, 0.8};
  scene.quality.settings = {{"texels", 1500},  {"trainings", 8}, {"field_rays", 8},
                            {"list_rays", 16}, {"node_rays", 4}, {"max_rank", 8}};
  light::Luminaire lamp;
  lamp.name = "Lamp";
  lamp.shape = light::Rectangle{0.6, 0.6};
  lamp.position = {2.0, 3.0, 2.9};
  lamp.flux = 2000.0;
  lamp.group = "General";
  scene.luminaires.push_back(lamp);
  scene.work_planes.push_back({"Desk", {0.5, 0.5, 0.8}, {3, 0, 0}, {0, 4, 0}, 4, 4, ""});
  scene.cameras.push_back({"Window", {2.0, 4.5, 1.6}, {2.0, 0.0, 1.7}, 50.0});
  scene.environment = scene::Environment{"", scene::Sky{.cie = 12,
                                                        .sun_azimuth_deg = 190.0,
                                                        .sun_altitude_deg = 40.0,
                                                        .horizontal_illuminance = 10000.0,
                                                        .direct_normal_illuminance = 40000.0,
                                                        .ground_reflectance = 0.2}};
  return project;
}

/// The same project under another sun.
inline scene::Environment withSunAt(scene::Environment environment, double azimuth_deg) {
  std::get<scene::Sky>(environment.light).sun_azimuth_deg = azimuth_deg;
  return environment;
}

}  // namespace soffit::ui
