// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/node_kernels.h"
#include "core/transfer/nodes.h"

#include <array>
#include <span>
#include <vector>

namespace soffit::transfer {

/// All bounces at the coarse level, for one to three colour channels at once: two bounces with
/// linear functions, the rest of the Neumann series on the patches' constants:
///   b1 = M F b0, e1 = F b0, e2 = F b1, (I - F_c M_c) tail = F_c M_c (F b1)_c.
/// M weights by the reflectance of each texel, so mixed materials and textures within a patch
/// are exact for the bounce that they reflect. Nothing is factorised: a reflectance can change at
/// any time, and the tail takes a handful of sparse products (linear_solver.h) whatever the size.
class NodeSolver {
 public:
  using Vectors = std::vector<std::vector<float>>;

  /// area: per slot. reflectance: of one to three channels, per slot, 0..1; the others are dark.
  /// nodes must outlive the solver.
  NodeSolver(const Nodes& nodes, std::span<const float> area,
             std::span<const std::span<const float>> reflectance);

  /// Irradiance after one and more reflections from the first radiosity b0 (reflectance x direct),
  /// both per patch. The tail is exact to 1e-4 of itself.
  void solve(std::span<const PatchLight> b0, std::span<PatchLight> indirect) const;

  /// The same from and to coefficients (restrictToNodes): a vector of nodes.stride per channel,
  /// padding 0; `indirect` is sized here.
  void solve(const Vectors& b0, Vectors& indirect) const;

  /// radiosity = M irradiance: what the patches send out of what they receive.
  void reflect(std::span<const PatchLight> irradiance, std::span<PatchLight> radiosity) const;

 private:
  void addTail(std::span<const PatchLight> b, std::span<PatchLight> e) const;

  const Nodes* nodes_;
  ConstantMatrix constants_;
  /// Per patch the symmetric 3 x 3 M_ab = 1/A sum A rho phi_a phi_b: 00, 01, 02, 11, 12, 22.
  std::vector<std::array<vec4, 6>> reflect_;
  std::vector<vec4> reflect_constant_;  ///< per patch M_00
  vec4 bright_{0.0F};                   ///< per channel: 1 if anything reflects, else 0
};

/// Coefficients of up to three channels per patch, and back.
std::vector<PatchLight> toPatches(const Nodes& nodes, const NodeSolver::Vectors& coefficients);
void fromPatches(const Nodes& nodes, std::span<const PatchLight> patches,
                 NodeSolver::Vectors& coefficients);

}  // namespace soffit::transfer
