// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soffit::transfer {

/// Light over one patch: RGB + padding coefficients of its functions, 0 for those that it lacks.
struct PatchLight {
  std::array<vec4, 3> c{vec4(0.0F), vec4(0.0F), vec4(0.0F)};
};
static_assert(sizeof(PatchLight) == 12 * sizeof(float));

/// Irradiance of patches from the radiosity of patches, geometry only: e = F b. Only pairs that see
/// each other are stored: a tenth of all in an office of several rooms.
struct NodeMatrix {
  struct Block {
    std::uint32_t sender = 0;      ///< patch
    std::array<float, 9> value{};  ///< receiver's functions x sender's; 0 for those that they lack
  };
  std::vector<std::uint32_t> first;  ///< per receiving patch its first block, then the end
  std::vector<Block> blocks;         ///< senders ascend

  /// What function b of a sender gives function a of a receiver, 0 for pairs that are not stored.
  [[nodiscard]] float at(std::size_t receiver, std::size_t a, std::size_t sender,
                         std::size_t b) const;
  [[nodiscard]] std::size_t bytes() const {
    return first.size() * sizeof(std::uint32_t) + blocks.size() * sizeof(Block);
  }
};

}  // namespace soffit::transfer
