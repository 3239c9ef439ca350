// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <string_view>
#include <vector>

/// A small line font of our own, so that legends need no font file on the machine.
///
/// Latin letters, digits and signs of ASCII and a few others (°, ², ·, ×, –, —, µ); letters with
/// the accents of Latin-1 lose the accent, everything else shows as a small box.
namespace soffit::render {

/// Height of capitals above the baseline, in the font's unit.
inline constexpr float kCapHeight = 12.0F;

/// A line of a text, from a to b; y is up, the baseline is y = 0.
struct Stroke {
  vec2 a;
  vec2 b;
};

/// A text laid out from x = 0 to the right.
struct StrokeText {
  std::vector<Stroke> strokes;
  float width = 0.0F;  ///< without space after the last sign
};

/// Text is UTF-8; broken sequences show as boxes. Curves become chords of at most `chord` units.
StrokeText layOut(std::string_view text, float chord = 0.75F);

}  // namespace soffit::render
