// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/color/tone_operator.h"
#include "core/math/vec.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace soffit::color {

/// The name of the view that shows illuminance (interfaces.md, View). Its transform takes the
/// place in the legend's range instead of a luminance: see false_color.h.
inline constexpr const char* kFalseColorView = "False colour";

/// What a picture is looked at through. Empty `config`: findDisplayConfig().
struct DisplayChoice {
  std::filesystem::path config;
  std::string display = "sRGB";
  std::string view = "Filmic";
  std::string look;  ///< empty: none
  /// Colour temperature that is shown as white, kelvin (white_balance.h); 0: daylight, D65. False
  /// colours have none.
  double white_balance = 0.0;
  /// Of the views that adapt (toneKindOf()): for the picture that is shown. Others do not read it.
  ToneOperator tone;

  friend bool operator==(const DisplayChoice&, const DisplayChoice&) = default;
};

/// The white that its view is balanced for: false colours stay as they are.
inline double balanceOf(const DisplayChoice& choice) {
  return choice.view == kFalseColorView ? 0.0 : choice.white_balance;
}

/// A view transform of OpenColorIO, ready to run. Immutable, cheap to copy, usable from any thread.
///
/// Takes scene-linear Rec.709 relative to 100 cd/m^2, exposure applied (exposure.h), and gives
/// code values of the display, 0..1.
class DisplayTransform {
 public:
  /// Errors: no config, unreadable config, a display, view or look that it lacks; for a view that
  /// adapts: a config without kPlainView.
  static Result<DisplayTransform> create(const DisplayChoice& choice);

  /// In place, on all threads. Never gives NaN: what is not a number or negative counts as black,
  /// what is infinite as the brightest white. Results are within 0..1.
  void apply(std::span<vec3> pixels) const;

  /// cd/m^2 to code values at an exposure in EV; out.size() == radiance.size().
  void apply(std::span<const vec3> radiance, double exposure_ev, std::span<vec3> out) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace soffit::color
