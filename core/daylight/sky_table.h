// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <functional>
#include <span>
#include <vector>

namespace soffit::daylight {

/// The sphere in cells of equal solid angle, equal steps of z and azimuth, with a weight each:
/// directions drawn in proportion to it.
class SkyTable {
 public:
  static constexpr int kRows = 128;     ///< of z, from -1
  static constexpr int kColumns = 256;  ///< of the azimuth from +x towards +y
  static constexpr std::size_t kCells = std::size_t{kRows} * kColumns;

  /// weights: kCells, not negative. A small share of the mean goes to every cell, so that nothing
  /// that shines into a dark cell's corner is missed.
  explicit SkyTable(std::span<const double> weights);

  [[nodiscard]] bool anyLight() const { return any_light_; }

  struct Drawn {
    dvec3 direction{0.0, 0.0, 1.0};
    double density = 0.0;  ///< per steradian
  };
  /// u in [0, 1)^2.
  [[nodiscard]] Drawn sample(const dvec2& u) const;
  [[nodiscard]] double density(const dvec3& d) const;

  static std::size_t cellOf(const dvec3& d);
  /// The direction at a place (0..1, 0..1) of a cell: azimuth, z.
  static dvec3 direction(std::size_t cell, const dvec2& at);

 private:
  std::vector<double> sums_;  ///< running, the last is the whole
  bool any_light_ = false;
};

}  // namespace soffit::daylight
