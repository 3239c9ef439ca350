// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/render/film.h"

#include <cstdint>
#include <vector>

namespace soffit::render {

/// The reflections of a picture, kept apart from the rest until they are smoothed.
struct SpecularLayer {
  struct Pixel {
    vec3 radiance{0.0F};    ///< reflected, cd/m^2, where the surface fills the pixel
    float coverage = 0.0F;  ///< share of the pixel that reflects; 0: none
    vec3 position{0.0F};
    vec3 normal{0.0F};  ///< shading normal
    float alpha = 0.0F;
    std::uint32_t material = 0;
    bool whole = false;  ///< has the whole set's quality by itself, and takes no part in others'
  };
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;  ///< empty where nothing reflects
};

/// Side of the block of pixels whose rays together make one low-discrepancy set.
inline constexpr int kPhases = 4;

/// Whether the pixel's own radiance is one part of a set, which the mean over a block completes.
[[nodiscard]] bool smooths(const SpecularLayer& layer, int x, int y);

/// Whether the pixel needs the whole set for itself: rough, and with less than three quarters of a
/// block's weight of pixels about it that look the same way. On curved surfaces a block has not one
/// lobe: smoothing would blur a highlight, and what it leaves out is missing in the mean.
[[nodiscard]] bool standsAlone(const SpecularLayer& layer, int x, int y);

/// Adds the layer to the film, rough reflections smoothed over the pixels of a block.
///
/// Neighbouring pixels trace different parts of one sample set (Keller & Heidrich 2001,
/// "Interleaved Sampling"); the mean over a block of kPhases x kPhases, weighted to be symmetric,
/// has the quality of the whole set. Pixels of another material, plane or direction take no part,
/// mirrors are not smoothed: a lobe is always wider than a block. Directions count as the same
/// within a quarter of the lobe's width (alpha, rad).
void addReflections(const SpecularLayer& layer, Film& film);

}  // namespace soffit::render
