// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/sampling.h"

#include <span>

namespace soffit::daylight {

/// The directions of the middles of the cells of the unit square, side x side, by
/// cosineHemisphere(). Those of 64, 128, 256 and 512 are kept: every receiver asks for the same
/// ones.
class SquareDirections {
 public:
  explicit SquareDirections(int side);
  /// About +z, unit.
  [[nodiscard]] vec3 at(int column, int row) const {
    if (!kept_.empty()) {
      return kept_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                   static_cast<std::size_t>(column)];
    }
    return cosineHemisphere((static_cast<float>(column) + 0.5F) / static_cast<float>(side_),
                            (static_cast<float>(row) + 0.5F) / static_cast<float>(side_));
  }

 private:
  int side_;
  std::span<const vec3> kept_;
};

}  // namespace soffit::daylight
