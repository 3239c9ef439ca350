// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soffit::render {

/// Which source of light to ask at a texel, drawn by how much of it arrives there directly: what
/// the engine knows already, shadows included. One source and one ray stand for all.
///
/// Sources are numbered: the luminaires of `lighting` in their order, then the environment's spots.
class LampChoice {
 public:
  explicit LampChoice(const relight::Lighting& lighting);

  struct Pick {
    std::size_t source = 0;
    double probability = 0.0;  ///< 0: there is no source
  };
  /// u in [0, 1). Any source that is on may come up at any slot, in a tenth of all draws: a texel
  /// knows the light at its own place alone.
  [[nodiscard]] Pick pick(std::uint32_t slot, double u) const;

 private:
  struct Share {
    std::uint32_t source = 0;
    float up_to = 0.0F;  ///< cumulative, the row's last is 1
  };
  std::vector<std::uint32_t> on_;     ///< sources that give light
  std::vector<std::uint32_t> first_;  ///< into shares_ per slot, and one past the last
  std::vector<Share> shares_;         ///< rows in the order of sources
};

}  // namespace soffit::render
