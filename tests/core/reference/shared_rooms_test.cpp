// SPDX-License-Identifier: MIT
#include "rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

/// The two rooms of ../shared/reference, whose illuminances another path tracer found.
namespace soffit::reference {
namespace {

struct SharedRoom {
  std::string name;
  std::map<std::string, double> reflectances;
  light::Rectangle panel;
  double flux = 0.0;
};

const SharedRoom kCornell{"cornell",
                          {{"floor", 0.3},
                           {"ceiling", 0.75},
                           {"wall", 0.7},
                           {"wallW", 0.6},
                           {"wallE", 0.3},
                           {"block", 0.5},
                           {"block2", 0.65}},
                          {0.6, 0.6},
                          3500.0};
const SharedRoom kFlat{"flat",
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

std::string fileOf(const SharedRoom& room, const std::string& file) {
  return std::string(SOFFIT_SHARED_DIR) + "/reference/" + room.name + "/" + file;
}

/// Reads the v, f (triangles without slashes) and usemtl lines of the room's OBJ file.
scene::Scene sceneOf(const SharedRoom& room) {
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
      std::string name;
      in >> name;
      scene.materials.push_back(test::matte(room.reflectances.at(name)));
    }
  }
  scene.mesh = mesh;
  return scene;
}

std::vector<std::vector<double>> numbersOf(const std::string& path, std::size_t skip) {
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

struct Comparison {
  double z_rms = 0.0;
  double bias = 0.0;        ///< of the mean
  double bias_error = 0.0;  ///< standard error of the bias
};

/// Every `stride`-th sensor with the light at a position of the path.
Comparison compare(const SharedRoom& room, std::size_t position, std::size_t stride) {
  const auto path = numbersOf(fileOf(room, "path.csv"), 0);
  light::Luminaire panel = test::luminaire(
      room.panel, {path[position][0], path[position][1], path[position][2]}, room.flux);
  panel.casts_shadow = true;
  const ReferenceScene scene = test::prepare(sceneOf(room), {panel});

  // After sensor, surface, room: x, y, z, nx, ny, nz, then lux and standard error per position.
  const auto rows = numbersOf(fileOf(room, "reference.csv"), 3);
  std::vector<scene::Sensor> sensors;
  std::vector<std::pair<double, double>> expected;
  for (std::size_t i = 0; i < rows.size(); i += stride) {
    const auto& r = rows[i];
    sensors.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
    expected.emplace_back(r[6 + 2 * position], r[7 + 2 * position]);
  }
  EstimateOptions options;
  options.relative_error = 0.02;
  options.paths_per_replicate = 256;
  const Estimate found = estimate(scene, sensors, options);
  EXPECT_TRUE(found.reached);

  Comparison c;
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const double error = found.sensors[i].total - expected[i].first;
    const double spread = std::hypot(found.sensors[i].standard_error, expected[i].second);
    c.z_rms += error * error / (spread * spread);
    c.bias += error;
    variance += spread * spread;
    sum += expected[i].first;
  }
  c.z_rms = std::sqrt(c.z_rms / static_cast<double>(sensors.size()));
  c.bias /= sum;
  c.bias_error = std::sqrt(variance) / sum;
  return c;
}

/// Statistical: the mean of n squared z-scores is 1 within sqrt(2 / n); the table's errors are
/// rounded to two digits, which adds a few per cent.
void expectAgreement(const Comparison& c) {
  EXPECT_GT(c.z_rms, 0.7);
  EXPECT_LT(c.z_rms, 1.3);
  EXPECT_LT(std::abs(c.bias), test::kSigmas * c.bias_error) << "bias " << c.bias;
}

TEST(SharedRooms, CornellAgreesAtPosition0) {
  expectAgreement(compare(kCornell, 0, 10));
}
TEST(SharedRooms, CornellAgreesAtPosition3) {
  expectAgreement(compare(kCornell, 3, 10));
}
TEST(SharedRooms, FlatAgreesAtPosition0) {
  expectAgreement(compare(kFlat, 0, 10));
}
TEST(SharedRooms, FlatAgreesAtPosition3) {
  expectAgreement(compare(kFlat, 3, 10));
}

}  // namespace
}  // namespace soffit::reference
