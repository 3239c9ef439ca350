// SPDX-License-Identifier: MIT
// The engine against the independent lux of ../shared/reference: two rooms, ten places of the
// light.
#include "tests/core/reference/shared_rooms.h"
#include "core/relight/engine.h"
#include "tests/core/relight/readings.h"

#include <algorithm>

namespace soffit::relight {
namespace {

using shared_rooms::Room;
using shared_rooms::Row;

/// Lux at every sensor with the light at each of the ten places.
std::vector<std::vector<double>> measured(const Room& room, std::span<const Row> rows) {
  scene::Scene scene = shared_rooms::sceneOf(room);
  for (std::size_t k = 0; k < shared_rooms::kPositions; ++k)
    scene.luminaires.push_back(shared_rooms::panelAt(room, k));
  EngineReport report;
  const auto solver = makeSolver(scene, QualitySettings{}, false, {}, report);
  EXPECT_TRUE(solver.ok());
  std::vector<scene::Sensor> sensors;
  for (const Row& row : rows) sensors.push_back(row.sensor);
  const Sensors ready(**solver, sensors, Quantity::planar, QualitySettings{}.sensor_rays, 1);
  std::vector<std::vector<double>> out;
  for (const light::Luminaire& l : scene.luminaires) {
    Lighting lighting(*solver);
    EXPECT_TRUE(lighting.setLuminaires(std::vector{l}).ok());
    std::vector<double> lux;
    for (const SensorLight& s : lighting.read(ready))
      lux.push_back(glm::dot(light::kLuminance, s.direct + s.indirect));
    out.push_back(std::move(lux));
  }
  return out;
}

struct Figures {
  double rms = 0.0;    ///< of the mean, the reference's own noise taken off in squares
  double noise = 0.0;  ///< of the reference, RMS of the mean
  double bias = 0.0;   ///< of the mean
};

template <class Choice>
Figures figures(std::span<const Row> rows, std::span<const double> lux, std::size_t position,
                const Choice& counts) {
  double square = 0.0;
  double noise = 0.0;
  double expected = 0.0;
  double found = 0.0;
  double n = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!counts(rows[i])) continue;
    const double r = rows[i].lux[position];
    square += (lux[i] - r) * (lux[i] - r);
    noise += rows[i].standard_error[position] * rows[i].standard_error[position];
    expected += r;
    found += lux[i];
    n += 1.0;
  }
  const double mean = expected / n;
  return {std::sqrt(std::max(0.0, square - noise) / n) / mean, std::sqrt(noise / n) / mean,
          found / expected - 1.0};
}

struct Limits {
  double rms;
  double bias;
};

template <class Choice>
void expectWithin(const std::string& what, std::span<const Row> rows,
                  const std::vector<std::vector<double>>& lux, const Limits& limits,
                  const Choice& counts) {
  for (std::size_t k = 0; k < lux.size(); ++k) {
    const Figures f = figures(rows, lux[k], k, counts);
    EXPECT_LT(f.rms, limits.rms) << what << ", place " << k
                                 << " (the reference's noise: " << f.noise << ")";
    EXPECT_LT(std::abs(f.bias), limits.bias) << what << ", place " << k;
  }
}

// With the settings that projects have unless they say otherwise. The promise is RMS 1 % of the
// mean at any place of the light, the aim 0.5 %.

TEST(EngineInSharedRooms, CornellAtAllPlaces) {
  const std::vector<Row> rows = shared_rooms::rowsOf(shared_rooms::kCornell);
  ASSERT_EQ(rows.size(), 600U);
  const auto lux = measured(shared_rooms::kCornell, rows);
  // Measured: RMS 0.08 to 0.22 %, bias 0.05 to 0.17 %.
  const Limits aim{0.005, 0.003};
  expectWithin("work plane", rows, lux, aim, [](const Row& r) { return r.work_plane; });
  expectWithin("surfaces", rows, lux, aim, [](const Row& r) { return !r.work_plane; });
}

TEST(EngineInSharedRooms, FlatAtAllPlaces) {
  const std::vector<Row> rows = shared_rooms::rowsOf(shared_rooms::kFlat);
  ASSERT_EQ(rows.size(), 577U);
  const auto lux = measured(shared_rooms::kFlat, rows);
  // Measured: RMS 0.08 to 0.32 % on the work plane, 0.30 to 0.56 % on surfaces; bias 0.1 %.
  expectWithin("work plane", rows, lux, {0.005, 0.003}, [](const Row& r) { return r.work_plane; });
  expectWithin("surfaces", rows, lux, {0.01, 0.003}, [](const Row& r) { return !r.work_plane; });
  // Behind the doorway, of that room's own mean of 3 to 6 lux. Measured: RMS 0.5 to 1.8 %, bias 0.6
  // %.
  expectWithin("work plane of room B", rows, lux, {0.03, 0.015},
               [](const Row& r) { return r.work_plane && r.part == 'B'; });
}

}  // namespace
}  // namespace soffit::relight
