// SPDX-License-Identifier: MIT
#include "core/daylight/square_directions.h"

#include <array>
#include <vector>

namespace soffit::daylight {
namespace {

constexpr int kSmallest = 64;
using Tables = std::array<std::vector<vec3>, 4>;

Tables makeTables() {
  Tables tables;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const int side = kSmallest << k;
    tables[k].reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        tables[k].push_back(
            cosineHemisphere((static_cast<float>(column) + 0.5F) / static_cast<float>(side),
                             (static_cast<float>(row) + 0.5F) / static_cast<float>(side)));
      }
    }
  }
  return tables;
}

}  // namespace

SquareDirections::SquareDirections(int side) : side_(side) {
  static const Tables kTables = makeTables();
  for (std::size_t k = 0; k < kTables.size(); ++k) {
    if (side == kSmallest << k) kept_ = kTables[k];
  }
}

}  // namespace soffit::daylight
