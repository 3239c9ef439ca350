// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstddef>
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

/// Share of a pixel's width for which one of so many samples stands: what textures are averaged
/// over per sample (1 / sqrt(n), as in pbrt, Pharr et al. 2023, ch. 10.1). The whole width for each
/// would blur a texture twice.
float textureShare(std::size_t samples);

}  // namespace soffit::render
