// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/node_matrix.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <span>
#include <vector>

/// The coarse level of the bounce: patches of up to 128 neighbouring texels that carry a linear
/// function each, and the geometric transfer between them.
namespace soffit::transfer {

/// Patches are consecutive slots of a cluster. Basis of a patch: phi_0 = 1, phi_1, phi_2 linear in
/// position, orthonormal under the texel areas: sum A phi_a phi_b = A_patch delta_ab.
struct Nodes {
  struct Patch {
    std::uint32_t begin = 0;  ///< slots
    std::uint32_t end = 0;
    std::uint32_t first = 0;  ///< first function
    std::uint32_t count = 1;  ///< 1..3 functions
    double area = 0.0;        ///< m^2; 0 for a patch without valid texels
  };
  std::vector<Patch> patches;
  std::vector<std::uint32_t> patch_of;  ///< per slot
  std::vector<vec2> phi;                ///< per slot: phi_1, phi_2 (0 where the patch lacks them)
  std::size_t functions = 0;
  std::size_t stride = 0;  ///< length of a vector of coefficients: `functions` rounded up to 16
  NodeMatrix matrix;
};

/// Makes patches and bases. area: m^2 per slot, 0 for texels that take no part.
Nodes makeNodes(const Texels& texels, std::span<const float> area, std::uint32_t patch_size);

/// Fills nodes.matrix from hits: for each slot `rays` texel slots (kNoTexel: lost), every ray of
/// equal weight (hemisphere.h), then makes it conserve energy: the light that a function sends
/// out arrives or leaves the scene, as counted from the sender's own rays. Without that the
/// sampling noise is amplified by 1/(1 - rho) (numerics.md 1.11).
void fillNodeMatrix(Nodes& nodes, std::span<const float> area, std::span<const std::uint32_t> hits, int rays);

/// coefficients[f] = 1/A sum A phi value over each patch; value per slot.
void restrictToNodes(const Nodes& nodes, std::span<const float> area, std::span<const float> value,
                     std::span<float> coefficients);

/// value[slot] = sum c phi.
void prolongFromNodes(const Nodes& nodes, std::span<const float> coefficients, std::span<float> value);

}  // namespace soffit::transfer
