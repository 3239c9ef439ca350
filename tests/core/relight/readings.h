// SPDX-License-Identifier: MIT
#pragma once

#include "tests/core/relight/rooms.h"

#include <cmath>
#include <span>
#include <vector>

/// Lux that the engine finds in a room, for the tests of the engine.
namespace soffit::relight::testing {

/// A room of 4 x 5 x 3 m with a block that stands free: 1 x 1.2 x 1 m.
inline std::shared_ptr<geometry::Mesh> blockRoom() {
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  addBox(*mesh, {1, 1, 0.3F}, {2, 2.2F, 1.3F}, false, 0);
  return mesh;
}

/// Sensors on a rectangular grid, cell centres of origin + [0,1] u + [0,1] v, normal u x v.
inline std::vector<scene::Sensor> grid(const dvec3& origin, const dvec3& u, const dvec3& v, int nu,
                                       int nv) {
  std::vector<scene::Sensor> sensors;
  const dvec3 n = glm::normalize(glm::cross(u, v));
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      sensors.push_back({origin + u * ((i + 0.5) / nu) + v * ((j + 0.5) / nv), n});
    }
  }
  return sensors;
}

/// A work plane of 5 x 6 points in blockRoom(), clear of the block, and three points on its walls.
inline std::vector<scene::Sensor> blockRoomSensors() {
  std::vector<scene::Sensor> sensors = grid({0.3, 0.4, 1.6}, {3.4, 0, 0}, {0, 4.2, 0}, 5, 6);
  sensors.push_back({{0.0, 1.5, 0.6}, {1, 0, 0}});
  sensors.push_back({{2.2, 0.0, 1.1}, {0, 1, 0}});
  sensors.push_back({{3.1, 3.9, 3.0}, {0, 0, -1}});
  return sensors;
}

struct Readings {
  std::vector<double> direct;    ///< lux (luminance)
  std::vector<double> indirect;  ///< lux (luminance)
};

inline Readings read(const Lighting& lighting, std::span<const scene::Sensor> sensors,
                     int rays = 64) {
  const Sensors ready(lighting.solver(), sensors, Quantity::planar, rays, 1);
  Readings out;
  for (const SensorLight& light : lighting.read(ready)) {
    out.direct.push_back(glm::dot(light::kLuminance, light.direct));
    out.indirect.push_back(glm::dot(light::kLuminance, light.indirect));
  }
  return out;
}

/// Bakes, lights and reads in one.
inline Readings readIn(const std::shared_ptr<const Solver>& solver,
                       const std::vector<light::Luminaire>& luminaires,
                       std::span<const scene::Sensor> sensors) {
  Lighting lighting(solver);
  const auto set = lighting.setLuminaires(luminaires);
  EXPECT_TRUE(set.ok());
  return read(lighting, sensors);
}

inline double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// RMS of factor * values - expected, relative to the mean of expected.
inline double relativeRms(std::span<const double> values, std::span<const double> expected,
                          double factor = 1.0) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += (factor * values[i] - expected[i]) * (factor * values[i] - expected[i]);
  }
  return std::sqrt(sum / static_cast<double>(values.size())) / std::abs(mean(expected));
}

/// Flux that the room's surfaces receive from all luminaires without reflection, lumens.
inline double directFlux(const Lighting& lighting) {
  const transfer::Operators& op = lighting.solver().operators();
  double sum = 0.0;
  for (const light::Emitter& emitter : lighting.emitters()) {
    Column column;
    lighting.solver().direct(emitter, {}, column);
    for (std::size_t s = 0; s < op.area.size(); ++s) {
      sum += static_cast<double>(op.area[s]) * static_cast<double>(column.direct[s]);
    }
  }
  return sum;
}

/// Flux that the room's surfaces receive in all, lumens.
inline double totalFlux(const Lighting& lighting) {
  const transfer::Operators& op = lighting.solver().operators();
  const Planes total = lighting.total();
  double sum = 0.0;
  for (std::size_t s = 0; s < op.area.size(); ++s)
    sum += static_cast<double>(op.area[s]) * luminance(total, s);
  return sum;
}

/// Every number is finite.
inline void expectFinite(const Lighting& lighting) {
  for (const auto& plane : lighting.total()) {
    for (const float e : plane) ASSERT_TRUE(std::isfinite(e));
  }
}

}  // namespace soffit::relight::testing
