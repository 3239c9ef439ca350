// SPDX-License-Identifier: MIT
#include "core/glossy/direction_table.h"

#include "core/sh/basis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::glossy {
namespace {

double signOf(double x) {
  return x < 0.0 ? -1.0 : 1.0;
}

/// The square [-1, 1]^2 to the sphere: the inner diamond is the upper half, the corners fold down.
dvec3 toSphere(const dvec2& p) {
  dvec3 d(p.x, p.y, 1.0 - std::abs(p.x) - std::abs(p.y));
  if (d.z < 0.0) {
    d.x = (1.0 - std::abs(p.y)) * signOf(p.x);
    d.y = (1.0 - std::abs(p.x)) * signOf(p.y);
  }
  return glm::normalize(d);
}

dvec2 toSquare(const dvec3& d) {
  const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  const dvec2 p(d.x / sum, d.y / sum);
  if (d.z >= 0.0) return p;
  return {(1.0 - std::abs(p.y)) * signOf(p.x), (1.0 - std::abs(p.x)) * signOf(p.y)};
}

}  // namespace

DirectionGrid::DirectionGrid(int side) : side_(side) {
  assert(side >= 2 && side % 2 == 0);
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      directions_.push_back(toSphere({2.0 * i / side - 1.0, 2.0 * j / side - 1.0}));
    }
  }
}

DirectionGrid::Taps DirectionGrid::taps(const dvec3& direction) const {
  const dvec2 p = (toSquare(direction) + 1.0) * (0.5 * side_);
  const int i = std::clamp(static_cast<int>(p.x), 0, side_ - 1);
  const int j = std::clamp(static_cast<int>(p.y), 0, side_ - 1);
  const double s = p.x - i;
  const double t = p.y - j;
  const auto row = static_cast<std::size_t>(side_ + 1);
  const std::size_t first = static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
  return {{first, first + 1, first + row, first + row + 1},
          {static_cast<float>((1.0 - s) * (1.0 - t)), static_cast<float>(s * (1.0 - t)),
           static_cast<float>((1.0 - s) * t), static_cast<float>(s * t)}};
}

DirectionTable::DirectionTable(const DirectionGrid& grid, std::size_t receivers, int bands)
    : grid_(grid),
      n_(sh::coefficientCount(bands)),
      bands_(bands),
      values_(receivers * grid.size() * n_) {}

void DirectionTable::set(std::size_t receiver, std::span<const double> matrix,
                         std::span<const float> kernel) {
  assert(matrix.size() == n_ * n_ && kernel.size() >= static_cast<std::size_t>(bands_));
  std::array<double, sh::kMaxCoefficients> basis;
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    sh::evaluate(grid_.direction(node), bands_, basis);
    transfer::Half* out = values_.data() + (receiver * grid_.size() + node) * n_;
    for (std::size_t i = 0; i < n_; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < n_; ++j) {
        sum += static_cast<double>(kernel[static_cast<std::size_t>(sh::degreeOf(j))]) * basis[j] *
               matrix[j * n_ + i];
      }
      out[i] = static_cast<float>(sum);
    }
  }
}

float DirectionTable::radiance(std::size_t receiver, std::span<const float> light,
                               const dvec3& axis) const {
  const DirectionGrid::Taps taps = grid_.taps(axis);
  float sum = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const transfer::Half* t = values_.data() + (receiver * grid_.size() + taps.node[k]) * n_;
    float product = 0.0F;
    for (std::size_t i = 0; i < n_; ++i) product += t[i] * light[i];
    sum += taps.weight[k] * product;
  }
  return sum;
}

std::vector<float> DirectionTable::underLight(std::size_t receiver,
                                              std::span<const float> light) const {
  std::vector<float> values(grid_.size(), 0.0F);
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    const transfer::Half* t = values_.data() + (receiver * grid_.size() + node) * n_;
    for (std::size_t i = 0; i < n_; ++i) values[node] += t[i] * light[i];
  }
  return values;
}

}  // namespace soffit::glossy
