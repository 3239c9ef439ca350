// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <vector>

namespace soffit::render {

/// Where in and around a pixel its samples lie, as offsets from the pixel's centre in pixels.
///
/// The points are a (0,2)-sequence (every power-of-two prefix is stratified in both axes and
/// together; Sobol' 1967) pushed through the inverse distribution of a tent of radius one pixel:
/// the samples are drawn from the reconstruction filter itself, so that their plain mean is the
/// filtered value and pixels stay independent (Ernst et al. 2006, "Filter Importance Sampling").
/// All pixels share the pattern: edges come out regular, without noise.
std::vector<vec2> pixelPattern(int samples);

}  // namespace soffit::render
