// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <vector>

/// Where the luminaires of an array hang.
namespace soffit::ui {

enum class ArrayKind { line_x, line_y, rectangle, circle };

/// The field that an array fills: a room, world x and y, m.
struct ArrayField {
  dvec2 lo{0.0};
  dvec2 hi{1.0};
  dvec2 through{0.5};  ///< a line passes through this place
};

/// What is counted and typed. A spacing of 0 is automatic: the field's length over the count, so
/// that the walls are half a spacing away.
struct ArraySettings {
  ArrayKind kind = ArrayKind::rectangle;
  int columns = 3;  ///< along x; of a circle and of a line: all
  int rows = 3;     ///< along y
  dvec2 spacing{0.0};
  double radius = 0.0;  ///< of a circle; 0: automatic, half of the way to the nearest wall
};

/// An array that fits: counts and spacings within what keeps all of it inside the field.
struct ArrayPlan {
  ArraySettings settings;        ///< as they could be kept; automatic ones with their values
  dvec2 wall_distance{0.0};      ///< from the first luminaire's middle to the wall
  std::vector<dvec2> places;     ///< row by row, x fastest; a circle from +x counter-clockwise
  std::vector<double> turn_deg;  ///< per place: of a circle, so that C0 looks outward; else 0
};

/// size  of one luminaire along x and y, m. No luminaire overhangs the field's edge: what is too
/// many or too wide is cut down.
ArrayPlan planArray(const ArraySettings& wanted, const ArrayField& field, const dvec2& size);

inline constexpr int kMostPerSide = 60;

}  // namespace soffit::ui
