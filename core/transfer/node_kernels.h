// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/node_lists.h"
#include "core/transfer/node_matrix.h"
#include "core/transfer/nodes.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The loops over node functions that run on every move, for the widest vector unit at hand
/// (Highway). The order of every sum is fixed: results do not depend on the thread count.
namespace soffit::transfer {

/// y = F x; x and y: per patch. In parallel.
void multiplyNodes(const NodeMatrix& matrix, std::span<const PatchLight> x,
                   std::span<PatchLight> y);

/// The constants of a node matrix alone: what patches give each other when all light is even.
struct ConstantMatrix {
  std::vector<std::uint32_t> first;   ///< per receiving patch its first pair, then the end
  std::vector<std::uint32_t> sender;  ///< per pair
  std::vector<float> value;           ///< per pair
};
ConstantMatrix constantsOf(const NodeMatrix& matrix);

/// y = F_c x; x and y: per patch. In parallel when the matrix is large.
void multiplyConstants(const ConstantMatrix& matrix, std::span<const vec4> x, std::span<vec4> y);

/// y[k] = node list first+k of b, k < y.size(); b: per patch. constants: b.c[0] side by side.
void gatherNodes(const NodeLists& lists, std::size_t first, std::span<const PatchLight> b,
                 std::span<const vec4> constants,
                 std::span<vec4> y);

/// The coefficients 1/A sum A phi rho max(e, 0) of a patch: what it sends out of irradiance e.
///
/// area  per slot of nodes; rho per channel and slot of nodes.
/// e     per channel, of the slots from patch.begin on; finite also where the area is 0.
PatchLight restrictSent(const Nodes& nodes, const Nodes::Patch& patch, std::span<const float> area,
                        const std::array<std::span<const float>, 3>& rho,
                        const std::array<const float*, 3>& e);

}  // namespace soffit::transfer
