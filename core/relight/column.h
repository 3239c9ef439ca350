// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/transfer/node_matrix.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soffit::relight {

/// Lux per slot of the operators' texels, by channel.
using Planes = std::array<std::vector<float>, 3>;

/// One luminaire's light at dimming 1 and a colour of Y = 1.
struct Column {
  std::vector<float> direct;      ///< lux per slot
  std::vector<std::uint8_t> lit;  ///< per cluster
  /// Response of each channel to white light of this luminaire (colour is applied by mixing):
  std::vector<vec4> skeleton;              ///< per gather list; empty with coarse operators
  std::vector<transfer::PatchLight> node;  ///< coarse operators: the indirect light per patch
};

}  // namespace soffit::relight
