// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>

namespace soffit::render {

/// What a picture is rendered for.
enum class Quantity {
  luminance,   ///< what an eye sees
  illuminance  ///< lux on the surfaces as they stand: no reflections, no bumps
};

/// Where the light of rough specular surfaces comes from. Mirrors trace rays by any method.
enum class Reflections : std::uint8_t {
  automatic,  ///< rays in final pictures; in quick ones harmonics
  none,       ///< specular surfaces show their diffuse light alone
  maps,       ///< cube maps of the lit room at probes
  harmonics,  ///< spherical harmonics where five bands serve the lobe, else maps
  rays
};

struct RenderOptions {
  int width = 1280;
  int height = 800;
  int samples = 4;  ///< per pixel, 1..1024; more than 4 only where a pixel needs them
  Quantity quantity = Quantity::luminance;
  std::uint64_t seed = 0;  ///< turns the sampling of rough reflections; nothing else is random

  Reflections reflections = Reflections::automatic;
  bool quick = false;  ///< a picture that must be there soon rather than right
  int reflection_samples =
      4;  ///< rays per pixel into strong rough lobes, times four of the lobe; >= 1
  int max_reflections = 2;  ///< mirrors seen in mirrors; 0: no reflections at all
  vec3 background{0.0F};    ///< what rays see that leave the scene, cd/m^2

  /// Luminance above which a sample's weight within a pixel falls off, cd/m^2; 0: never. Keeps
  /// the edges of luminaires smooth after tone mapping; exact radiometry wants 0.
  float edge_white = 0.0F;
  int tile = 32;  ///< pixels a side
};

}  // namespace soffit::render
