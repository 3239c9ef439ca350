// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/nodes.h"

#include <memory>
#include <span>
#include <vector>

namespace soffit::transfer {

/// All bounces at the coarse level, for one color channel: two bounces with linear functions, the
/// rest of the Neumann series in closed form on the patches' constants:
///   b1 = M F b0, e1 = F b0, e2 = F b1, tail = F_c (I - M_c F_c)^-1 M_c (F b1)_c.
/// M weights by the reflectance of each texel, so mixed materials and textures within a patch
/// are exact for the bounce that they reflect. The factorisation costs 2/3 patches^3 flops, so a
/// reflectance can change at any time.
class NodeSolver {
 public:
  /// reflectance, area: per slot; reflectance 0..1. nodes must outlive the solver.
  NodeSolver(const Nodes& nodes, std::span<const float> area, std::span<const float> reflectance);
  ~NodeSolver();
  NodeSolver(NodeSolver&&) noexcept;
  NodeSolver& operator=(NodeSolver&&) noexcept;

  /// Irradiance coefficients after one and more reflections from the coefficients of the first
  /// radiosity b0 (restrictToNodes of reflectance x direct). Sizes: nodes.stride, padding 0.
  void solve(std::span<const float> b0, std::span<float> indirect) const;

  /// radiosity = M irradiance: what the patches send out of what they receive.
  void reflect(std::span<const float> irradiance, std::span<float> radiosity) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// y = matrix x for the node matrix; rows in parallel, fixed order of summation.
void multiplyNodeMatrix(const Nodes& nodes, std::span<const float> x, std::span<float> y);

}  // namespace soffit::transfer
