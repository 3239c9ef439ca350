// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/color_map.h"
#include "core/color/false_color.h"

#include <vector>

/// The one scale of illuminance that false colours, isolux lines, numbers and legend share.
namespace soffit::color {

/// The unit in which illuminance is shown; everything else is in lux.
enum class LuxUnit { lux, footcandle };

/// Lumens per square foot in lux, exactly 1 / 0.3048^2.
inline constexpr double kLuxPerFootcandle = 1.0 / (0.3048 * 0.3048);

constexpr double luxPer(LuxUnit unit) {
  return unit == LuxUnit::footcandle ? kLuxPerFootcandle : 1.0;
}
constexpr const char* nameOf(LuxUnit unit) {
  return unit == LuxUnit::footcandle ? "fc" : "lx";
}

/// Most steps of a scale, and most lines.
inline constexpr int kMostSteps = 24;
inline constexpr std::size_t kMostLevels = 32;

struct LuxScale {
  FalseColorRange range;  ///< lux
  ColorMap map = ColorMap::violet_yellow;
  int steps = 0;  ///< bands of one color each, 2 to kMostSteps; 0: continuous
  LuxUnit unit = LuxUnit::lux;

  /// Where the color at a place in 0..1 is taken from the map: the place itself, or that of its
  /// band; bands are spread so that the first and the last show the ends of the map.
  [[nodiscard]] float placeInMap(float place) const;
  /// sRGB code values.
  [[nodiscard]] vec3 colorAt(float place) const { return colorMapAt(map, placeInMap(place)); }
  [[nodiscard]] vec3 color(float lux) const { return colorAt(range.place(lux)); }

  friend bool operator==(const LuxScale&, const LuxScale&) = default;
};

/// Values for a legend, ascending, labelled in the scale's unit: round ones, at most `most`; where
/// the scale has steps, their borders, or every second, third.. of them.
std::vector<LegendTick> legendTicks(const LuxScale& scale, int most);

/// Which illuminances lines are drawn at.
enum class LevelSeries {
  round,     ///< round values all over the scale: those of its legend
  standard,  ///< 0.5 1 2 3 5 7.5 10 15 20 30 50 75 100 .. as lighting standards grade values
  chosen,
};

/// Levels in lux, ascending, above 0, at most kMostLevels. `chosen` (lux, any order) counts for
/// LevelSeries::chosen alone. On a linear scale `standard` begins at a fiftieth of its end: smaller
/// ones would lie on one another.
std::vector<double> isoLevels(const LuxScale& scale, LevelSeries series,
                              const std::vector<double>& chosen = {});

}  // namespace soffit::color
