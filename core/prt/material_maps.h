// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/surfaces.h"

#include <cstdint>

/// What a material's pictures say at a place on a surface.
namespace soffit::prt {

/// A place on a triangle.
struct MapPlace {
  std::uint32_t triangle = 0;
  float u = 0.0F, v = 0.0F;  ///< barycentric: (1-u-v) a + u b + v c
  float width = 0.0F;        ///< m, of the piece of surface that is averaged over
};

/// Mean of a picture (3 channels, row 0 at the top, repeated) about uv over a square of `width` of
/// uv's unit: up to 8 x 8 bilinear looks. uv that is not finite counts as (0, 0).
vec3 meanOf(const scene::Image& image, const vec2& uv, const vec2& width);

/// Diffuse albedo, the map's mean over the place applied; linear Rec.709, 0..1.
vec3 reflectanceAt(const Surfaces& surfaces, const MapPlace& place);

/// Unit shading normal on the front's side: interpolated vertex normals, bent by the mean of the
/// normal map (tangent space, x along u, y along v, 0.5 0.5 1 is flat) as pictures bend it.
vec3 shadingNormalAt(const Surfaces& surfaces, const MapPlace& place);

}  // namespace soffit::prt
