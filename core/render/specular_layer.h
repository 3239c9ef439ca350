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
  };
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;  ///< empty where nothing reflects
};

/// Side of the block of pixels whose rays together make one low-discrepancy set.
inline constexpr int kPhases = 4;

/// Adds the layer to the film, rough reflections smoothed over the pixels of a block.
///
/// Neighbouring pixels trace different parts of one sample set (Keller & Heidrich 2001,
/// "Interleaved Sampling"); the mean over a block of kPhases x kPhases, weighted to be symmetric,
/// has the quality of the whole set. Pixels of another material, plane or direction take no part,
/// mirrors are not smoothed: a lobe is always wider than a block.
void addReflections(const SpecularLayer& layer, Film& film);

}  // namespace soffit::render
