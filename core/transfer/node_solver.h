// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/nodes.h"

#include <memory>
#include <span>
#include <vector>

namespace soffit::transfer {

/// All bounces at the coarse level, for one to three colour channels at once: two bounces with
/// linear functions, the rest of the Neumann series in closed form on the patches' constants:
///   b1 = M F b0, e1 = F b0, e2 = F b1, tail = F_c (I - M_c F_c)^-1 M_c (F b1)_c.
/// M weights by the reflectance of each texel, so mixed materials and textures within a patch
/// are exact for the bounce that they reflect. The factorisation costs 2/3 patches^3 flops a
/// channel, so a reflectance can change at any time.
class NodeSolver {
 public:
  using Vectors = std::vector<std::vector<float>>;

  /// area: per slot. reflectance: per channel and slot, 0..1. nodes must outlive the solver.
  NodeSolver(const Nodes& nodes, std::span<const float> area, std::span<const std::span<const float>> reflectance);
  ~NodeSolver();
  NodeSolver(NodeSolver&&) noexcept;
  NodeSolver& operator=(NodeSolver&&) noexcept;

  /// Irradiance coefficients after one and more reflections from the coefficients of the first
  /// radiosity b0 (restrictToNodes of reflectance x direct). A vector of nodes.stride per
  /// channel, padding 0; `indirect` is sized here.
  void solve(const Vectors& b0, Vectors& indirect) const;

  /// radiosity = M irradiance of one channel: what the patches send out of what they receive.
  void reflect(std::size_t channel, std::span<const float> irradiance, std::span<float> radiosity) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace soffit::transfer
