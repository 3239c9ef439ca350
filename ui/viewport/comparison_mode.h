// SPDX-License-Identifier: MIT
#pragma once

namespace soffit::ui {

/// How two layouts are seen together.
enum class ComparisonMode {
  off,
  split,         ///< one picture, a slider between the two
  side_by_side,  ///< two pictures, one camera
  blink,         ///< one after the other, in place
  difference     ///< illuminance of the second minus that of the first
};

}  // namespace soffit::ui
