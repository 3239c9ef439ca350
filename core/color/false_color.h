// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/math/vec.h"

#include <string>
#include <vector>

/// Illuminance as colour, with the legend that makes it readable.
///
/// The map runs from violet through teal to yellow with evenly rising lightness (Oklab), so the
/// order survives colour blindness and black-and-white prints. It is computed by
/// resources/ocio/generate.py, which writes the same map as the OCIO view "False colour".
namespace soffit::color {

/// Which values the map spans, in lux.
struct FalseColorRange {
  double min = 0.0;
  double max = 1000.0;
  bool logarithmic = false;

  /// Errors: not finite, max <= min, or a logarithmic range from 0 or below.
  [[nodiscard]] Result<void> check() const;

  /// Place of a value in the range: 0 at or below min, 1 at or above max. NaN gives 0.
  [[nodiscard]] float place(float lux) const;

  friend bool operator==(const FalseColorRange&, const FalseColorRange&) = default;
};

/// sRGB code values (0..1) at a place in 0..1; values outside are clamped, NaN counts as 0.
vec3 falseColorAt(float place);

/// sRGB code values of an illuminance.
inline vec3 falseColor(float lux, const FalseColorRange& range) {
  return falseColorAt(range.place(lux));
}

/// A line of the legend.
struct LegendTick {
  double lux = 0.0;
  float place = 0.0F;  ///< 0..1 along the bar
  std::string label;   ///< "500", "2.5"; without unit
};

/// Round values (1, 2, 5 x 10^n; 2.5 too on linear ranges) in the range, ascending, at most
/// `most` >= 2 of them. The range is valid.
std::vector<LegendTick> legendTicks(const FalseColorRange& range, int most);

/// A range with round ends for values up to `highest` lux, linear from 0.
FalseColorRange roundRange(double highest);

}  // namespace soffit::color
