// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

/// Tone operators that adapt to the picture: views beside those of the OCIO config, which do not
/// know what they show. They act on luminance and keep the chromaticity.
namespace soffit::color {

enum class ToneKind : std::uint8_t { reinhard_2002, tumblin_rushmeier };

inline constexpr const char* kReinhard2002View = "Reinhard 2002";
inline constexpr const char* kTumblinRushmeierView = "Tumblin-Rushmeier";
/// The config's view that encodes what a tone operator gives: linear up to the display's white.
inline constexpr const char* kPlainView = "sRGB";

/// The operator of a view's name; nothing for the config's own views.
std::optional<ToneKind> toneKindOf(const std::string& view);

/// What a user may set; 0: as the picture asks for.
struct ToneSettings {
  double key = 0.0;  ///< display value of the picture's log-average, mid grey 0.18 (Reinhard 2002)
  double white =
      0.0;  ///< the smallest luminance that becomes white, in those units (Reinhard 2002)

  friend bool operator==(const ToneSettings&, const ToneSettings&) = default;
};

/// Luminances of a picture, cd/m^2, the brightest and the darkest percent left out.
struct PictureLuminance {
  double log_average = 18.0;
  double least = 1.0;
  double most = 100.0;

  friend bool operator==(const PictureLuminance&, const PictureLuminance&) = default;
};

/// radiance  linear Rec.709, cd/m^2; pixels that are black, negative or not finite are left out. A
///           picture without light has the default.
/// step      every so many pixels are looked at.
PictureLuminance pictureLuminance(std::span<const vec3> radiance, std::size_t step = 1);

/// A curve from scene-linear luminance relative to 100 cd/m^2, exposure applied, to the display's
/// linear luminance, white 1.
struct ToneOperator {
  ToneKind kind = ToneKind::reinhard_2002;
  float a = 1.0F;
  float b = 0.0F;

  /// Reinhard 2002: s (1 + s b) / (1 + s), s = a y; Tumblin-Rushmeier: a y^b. 0 where y <= 0.
  [[nodiscard]] float displayed(float y) const;
  /// A color of scene-linear Rec.709 with that luminance; not below 0, may exceed 1.
  [[nodiscard]] vec3 displayed(const vec3& rgb) const;

  friend bool operator==(const ToneOperator&, const ToneOperator&) = default;
};

/// Reinhard 2002: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital
/// Images", eq. 1, 2 and 4; key and white after Reinhard, "Parameter Estimation for Photographic
/// Tone Reproduction" (Journal of Graphics Tools 7(1), 2002), eq. 4 and 5, where they are not set.
///
/// Tumblin-Rushmeier: as revised in Tumblin, Hodgins & Guenter, "Two Methods for Display of High
/// Contrast Images" (ACM Transactions on Graphics 18(1), 1999), appendix:
/// L_d = m(L_wa) L_da (L_w / L_wa)^(g(L_wa) / g(L_da)), m = sqrt(C)^(g(L_wa) / (1.855 + 0.4 log10
/// L_da)
/// - 1), for a display of 100 cd/m^2 and a contrast C of 35, L_da = 100 / sqrt(C). It has no
/// settings.
ToneOperator makeToneOperator(ToneKind kind, const PictureLuminance& picture,
                              const ToneSettings& settings = {});

/// GLSL of `vec3 soffitTone(vec3 rgb)`: ToneOperator::displayed() with a and b in the uniform vec2
/// `soffit_tone`.
std::string toneShader(ToneKind kind);

}  // namespace soffit::color
