// SPDX-License-Identifier: MIT
#include "core/daylight/sky_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::daylight {
namespace {

constexpr double kEverywhere = 0.02;  // share of the mean that every cell gets
constexpr double kCellAngle = 4.0 * kPi / static_cast<double>(SkyTable::kCells);

}  // namespace

SkyTable::SkyTable(std::span<const double> weights) {
  assert(weights.size() == kCells);
  double mean = 0.0;
  for (const double w : weights) mean += w;
  any_light_ = mean > 0.0;
  mean /= static_cast<double>(kCells);
  const double least = any_light_ ? kEverywhere * mean : 1.0;
  double sum = 0.0;
  sums_.reserve(kCells);
  for (const double w : weights) sums_.push_back(sum += w + least);
}

std::size_t SkyTable::cellOf(const dvec3& d) {
  const double azimuth = std::atan2(d.y, d.x) / (2.0 * kPi);
  const int row = std::clamp(static_cast<int>((0.5 + 0.5 * d.z) * kRows), 0, kRows - 1);
  const int column =
      std::clamp(static_cast<int>((azimuth - std::floor(azimuth)) * kColumns), 0, kColumns - 1);
  return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
}

dvec3 SkyTable::direction(std::size_t cell, const dvec2& at) {
  const double z = 2.0 * (static_cast<double>(cell / kColumns) + at.y) / kRows - 1.0;
  const double phi = 2.0 * kPi * (static_cast<double>(cell % kColumns) + at.x) / kColumns;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

SkyTable::Drawn SkyTable::sample(const dvec2& u) const {
  const double target = u.x * sums_.back();
  const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, target);
  const auto cell = static_cast<std::size_t>(found - sums_.begin());
  const double before = cell == 0 ? 0.0 : sums_[cell - 1];
  const double weight = sums_[cell] - before;
  const double within = std::clamp((target - before) / weight, 0.0, 1.0 - 1e-12);
  return {direction(cell, {within, u.y}), weight / (sums_.back() * kCellAngle)};
}

double SkyTable::density(const dvec3& d) const {
  const std::size_t cell = cellOf(d);
  const double before = cell == 0 ? 0.0 : sums_[cell - 1];
  return (sums_[cell] - before) / (sums_.back() * kCellAngle);
}

}  // namespace soffit::daylight
