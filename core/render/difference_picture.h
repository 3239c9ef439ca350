// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/color/false_color.h"
#include "core/math/vec.h"
#include "core/render/film.h"
#include "core/scene/material.h"

#include <optional>
#include <string>
#include <vector>

/// Where one lighting is brighter than another, in lux.
namespace soffit::render {

/// sRGB code values of a difference at a place in -1..1: blue where it is darker, near-white where
/// nothing changed, orange where it is brighter. Both arms fall evenly in lightness, and blue and
/// orange stay apart for every kind of color blindness. Values outside are clamped, NaN is 0.
vec3 differenceColor(float place);

/// Round values for the legend of a scale from -range to +range lux, ascending, about `most`;
/// places are 0..1 along the bar.
std::vector<color::LegendTick> differenceTicks(double range, int most);

struct DifferenceOptions {
  std::optional<double> range_lux;  ///< the ends of the scale, > 0; absent: what the picture holds
  bool legend = true;
  std::string title;
};

/// `second` - `first`, illuminance of surfaces pixel by pixel; luminaires of either in grey, what
/// lies beyond the scene dark. Films of one camera.
/// Errors: films of different sizes; a range that is not above 0.
Result<scene::Image> differencePicture(const Film& first, const Film& second,
                                       const DifferenceOptions& options);

/// A round value that covers all but two percent of the differences.
double fittingDifference(const Film& first, const Film& second);

}  // namespace soffit::render
