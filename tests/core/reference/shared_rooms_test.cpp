// SPDX-License-Identifier: MIT
#include "tests/core/reference/shared_rooms.h"
#include "rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::reference {
namespace {

using namespace shared_rooms;

struct Comparison {
  double z_rms = 0.0;
  double bias = 0.0;        ///< of the mean
  double bias_error = 0.0;  ///< standard error of the bias
};

/// Every `stride`-th sensor with the light at a position of the path.
Comparison compare(const Room& room, std::size_t position, std::size_t stride) {
  const ReferenceScene scene = test::prepare(sceneOf(room), {panelAt(room, position)});
  const std::vector<Row> rows = rowsOf(room);
  std::vector<scene::Sensor> sensors;
  std::vector<std::pair<double, double>> expected;
  for (std::size_t i = 0; i < rows.size(); i += stride) {
    sensors.push_back(rows[i].sensor);
    expected.emplace_back(rows[i].lux[position], rows[i].standard_error[position]);
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
