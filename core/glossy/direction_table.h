// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"
#include "core/transfer/half.h"

#include <array>
#include <span>
#include <vector>

/// Reflection by discretised directions (Kautz, Sloan & Snyder 2002; lecture notes on PRT): a
/// coefficient vector per receiver and reflection direction, interpolated between directions.
namespace soffit::glossy {

/// Nodes over the sphere, (side + 1)^2 on the octahedral map (Engelhardt & Dachsbacher 2008). The
/// nodes of the map's border stand for directions that two of its edges share.
class DirectionGrid {
 public:
  /// side >= 2, even, so that the poles are nodes.
  explicit DirectionGrid(int side);

  [[nodiscard]] std::size_t size() const { return directions_.size(); }
  [[nodiscard]] const dvec3& direction(std::size_t node) const { return directions_[node]; }

  /// Four nodes and their weights, which sum to 1; direction unit.
  struct Taps {
    std::array<std::size_t, 4> node{};
    std::array<float, 4> weight{};
  };
  [[nodiscard]] Taps taps(const dvec3& direction) const;

 private:
  int side_;
  std::vector<dvec3> directions_;
};

/// Reflected coefficient vectors of many receivers: t_i(d) = sum over j of k_j y_j(d) M_ji, so that
/// the radiance that leaves about the reflection direction d is t(d) . L. Roughness is fixed.
/// 2 n^2 bytes per receiver and node: 81 nodes of 25 take 6.5 times what a symmetric matrix does;
/// what is saved is the product with it.
class DirectionTable {
 public:
  DirectionTable(const DirectionGrid& grid, std::size_t receivers, int bands);

  /// matrix: n^2 x n^2, row-major (transfer_matrix.h); kernel: n values of the receiver's lobe.
  void set(std::size_t receiver, std::span<const double> matrix, std::span<const float> kernel);

  /// Radiance along `axis` under light of n^2 coefficients, four dot products. The error of the
  /// interpolation is (spacing of the nodes)^2 / 8 times the second derivative of a lobe's
  /// response: measured in tests and by `soffit bench glossy`.
  [[nodiscard]] float radiance(std::size_t receiver, std::span<const float> light,
                               const dvec3& axis) const;

  /// Radiance per node under a fixed light: what a moving eye alone needs. One number per node.
  [[nodiscard]] std::vector<float> underLight(std::size_t receiver,
                                              std::span<const float> light) const;

  [[nodiscard]] std::size_t bytes() const { return values_.size() * sizeof(transfer::Half); }

 private:
  const DirectionGrid& grid_;
  std::size_t n_;
  int bands_;
  std::vector<transfer::Half> values_;  ///< [receiver][node][coefficient]
};

}  // namespace soffit::glossy
