// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"
#include "core/scene/scene.h"

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

/// The two rooms of ../shared/reference, whose illuminances another path tracer found: one light at
/// ten places, fixed sensors.
namespace soffit::shared_rooms {

struct Room {
  std::string name;
  std::map<std::string, double> reflectances;
  light::Rectangle panel;
  double flux = 0.0;
};

inline const Room kCornell{"cornell",
                           {{"floor", 0.3},
                            {"ceiling", 0.75},
                            {"wall", 0.7},
                            {"wallW", 0.6},
                            {"wallE", 0.3},
                            {"block", 0.5},
                            {"block2", 0.65}},
                           {0.6, 0.6},
                           3500.0};
inline const Room kFlat{"flat",
                        {{"floor", 0.35},
                         {"ceiling", 0.8},
                         {"wall", 0.7},
                         {"frame", 0.6},
                         {"wood", 0.4},
                         {"fabric", 0.3},
                         {"white", 0.75},
                         {"door", 0.65}},
                        {0.4, 0.4},
                        2500.0};

inline std::string fileOf(const Room& room, const std::string& file) {
  return std::string(SOFFIT_SHARED_DIR) + "/reference/" + room.name + "/" + file;
}

/// Reads the v, f (triangles without slashes) and usemtl lines of the room's OBJ file.
inline scene::Scene sceneOf(const Room& room) {
  auto mesh = std::make_shared<geometry::Mesh>();
  scene::Scene scene;
  std::ifstream file(fileOf(room, room.name + ".obj"));
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream in(line);
    std::string key;
    in >> key;
    if (key == "v") {
      vec3 p;
      in >> p.x >> p.y >> p.z;
      mesh->positions.push_back(p);
    } else if (key == "f") {
      uvec3 t;
      in >> t.x >> t.y >> t.z;
      mesh->triangles.push_back(t - 1U);
      mesh->material_of.push_back(static_cast<std::uint32_t>(scene.materials.size() - 1));
    } else if (key == "usemtl") {
      scene::Material material;
      in >> material.name;
      material.diffuse = dvec3(room.reflectances.at(material.name));
      scene.materials.push_back(material);
    }
  }
  scene.mesh = mesh;
  return scene;
}

/// The numbers of a CSV file without its header and the first `skip` columns.
inline std::vector<std::vector<double>> numbersOf(const std::string& path, std::size_t skip) {
  std::vector<std::vector<double>> rows;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);  // header
  while (std::getline(file, line)) {
    std::vector<double> row;
    std::istringstream in(line);
    std::string cell;
    for (std::size_t i = 0; std::getline(in, cell, ','); ++i) {
      if (i >= skip) row.push_back(std::stod(cell));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

inline constexpr std::size_t kPositions = 10;

/// The light at a position of the path.
inline light::Luminaire panelAt(const Room& room, std::size_t position) {
  static std::map<std::string, std::vector<std::vector<double>>> paths;
  auto& path = paths[room.name];
  if (path.empty()) path = numbersOf(fileOf(room, "path.csv"), 0);
  light::Luminaire panel;
  panel.name = "Moving";
  panel.shape = room.panel;
  panel.position = {path[position][0], path[position][1], path[position][2]};
  panel.flux = room.flux;
  panel.casts_shadow = true;
  return panel;
}

/// A row of reference.csv.
struct Row {
  scene::Sensor sensor;
  bool work_plane = false;
  char part = 'A';                     ///< of the flat
  std::vector<double> lux;             ///< per position
  std::vector<double> standard_error;  ///< lux, per position
};

inline std::vector<Row> rowsOf(const Room& room) {
  const std::string path = fileOf(room, "reference.csv");
  std::vector<Row> rows;
  for (const auto& n : numbersOf(path, 3)) {
    Row row;
    row.sensor = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    for (std::size_t k = 0; k < kPositions; ++k) {
      row.lux.push_back(n[6 + 2 * k]);
      row.standard_error.push_back(n[7 + 2 * k]);
    }
    rows.push_back(std::move(row));
  }
  // The words of the first columns.
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  for (Row& row : rows) {
    std::getline(file, line);
    std::istringstream in(line);
    std::string sensor;
    std::string surface;
    std::string part;
    std::getline(in, sensor, ',');
    std::getline(in, surface, ',');
    std::getline(in, part, ',');
    row.work_plane = surface == "work_plane";
    row.part = part.empty() ? ' ' : part.front();
  }
  return rows;
}

}  // namespace soffit::shared_rooms
