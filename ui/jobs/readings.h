// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/compare.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soffit::ui {

/// What the work planes of one layout read, with the flux and the power that it takes.
struct LayoutReading {
  std::string layout;             ///< empty: the base
  design::LayoutFigures figures;  ///< named "Base" for the base
  std::vector<float> points;      ///< lux at the work planes' points, plane by plane
  double watts = 0.0;             ///< declared input power of what is on, as it is dimmed
  std::size_t unknown_power = 0;  ///< luminaires that are on and whose power no file declares
  bool current = true;            ///< false: luminaires changed since, the reading is under way
};

/// The readings of all layouts. Immutable once handed over.
struct Readings {
  std::vector<LayoutReading> layouts;  ///< the base only where it is shown or there is no other
  std::string shown;                   ///< the layout in the view
  double area_m2 = 0.0;                ///< of all work planes
  bool coarse = false;                 ///< of the first, rough light transport
  std::uint64_t revision = 0;          ///< of the request that they answer
};
using ReadingsPtr = std::shared_ptr<const Readings>;

}  // namespace soffit::ui
