// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/node_matrix.h"
#include "core/transfer/operators.h"

#include <array>
#include <span>
#include <vector>

namespace soffit::transfer {

/// What a cluster's patches send on of the light at its skeleton points: restriction to node
/// functions, reflectance and interpolation in one, so that no texel is visited between the first
/// bounce and the nodes:
///   sent_a = sum_k value_ka y_k,   value_ka = 1/A sum_s area_s rho_s phi_a(s) W_sk.
/// Interpolated light below 0, which display cuts off, stays in: the sum is the better for it.
struct PatchWeights {
  std::vector<std::size_t> first;          ///< per patch: into value
  std::vector<std::array<vec4, 3>> value;  ///< per skeleton point of the patch's cluster: RGB + 0
};

/// rho: reflectance of three channels, per slot. Operators must have weights (not coarse).
PatchWeights makePatchWeights(const Operators& operators,
                              const std::array<std::span<const float>, 3>& rho);

/// The light that a patch sends on; y: the skeleton values of its cluster, RGB + padding.
PatchLight sentOn(const PatchWeights& weights, std::size_t patch, std::span<const vec4> y);

}  // namespace soffit::transfer
