// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/lux_scale.h"

/// In which units lengths and illuminance are shown and typed. A matter of the display: values in
/// memory and files stay metres and lux.
namespace soffit::ui {

enum class Units {
  metric,   ///< m, lx
  imperial  ///< ft, fc
};

inline constexpr double kMetresPerFoot = 0.3048;

/// Those of the user's settings, metric when there are none.
Units savedUnits();
void saveUnits(Units units);
/// Those that are shown now.
Units shownUnits();
/// Shows others in the whole application: widgets get a QEvent::LocaleChange and paint anew.
void applyUnits(Units units);

inline color::LuxUnit luxUnitOf(Units units) {
  return units == Units::imperial ? color::LuxUnit::footcandle : color::LuxUnit::lux;
}

}  // namespace soffit::ui
