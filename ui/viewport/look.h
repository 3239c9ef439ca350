// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/display_transform.h"
#include "core/color/lux_scale.h"
#include "core/render/bloom.h"

#include <optional>
#include <vector>

namespace soffit::ui {

/// How a view shows light.
struct Look {
  color::DisplayChoice display;  ///< used unless false_color
  double exposure_ev = 0.0;      ///< ignored by false colour
  color::ToneSettings tone;      ///< of views that adapt (color::toneKindOf())
  /// What those adapt to; absent: the picture. Views that are compared share one.
  std::optional<color::PictureLuminance> adapted_to;
  render::Bloom bloom;       ///< ignored by false colour
  bool false_color = false;  ///< illuminance by colour, on the scale
  color::LuxScale scale;
  /// Isolux lines are drawn on all surfaces at these values, lux, ascending; empty: none.
  std::vector<double> levels;
  /// Takes the false colours of a difference (render::differenceColor) with grey luminaires, over
  /// the scale's range; light that is a difference is made by differenceLight().
  bool difference = false;

  friend bool operator==(const Look&, const Look&) = default;
};

/// The same without false colours and lines: for pictures that are to be like one another.
inline Look plain(Look look) {
  look.false_color = look.difference = false;
  look.levels.clear();
  return look;
}

}  // namespace soffit::ui
