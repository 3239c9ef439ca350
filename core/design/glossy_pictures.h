// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/math/box.h"
#include "core/reference/reference_scene.h"
#include "core/render/illumination.h"
#include "core/render/view_scene.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

/// How near the methods for reflections come to the path tracer in a picture.
namespace soffit::design {

/// Luminance over some pixels of a picture, luminaires that are looked at left out.
struct GlossyPictureRow {
  std::string camera;
  std::string method;  ///< "matte alone", "rays", "reflection maps", "harmonics, 5 bands"
  std::string part;    ///< "picture", or the material of the pixels and its roughness
  std::size_t pixels = 0;
  double mean = 0.0;   ///< of the path tracer, cd/m2
  double rms = 0.0;    ///< error, share of the picture's mean
  double bias = 0.0;   ///< mean error, share of the picture's mean
  double noise = 0.0;  ///< the path tracer's own RMS noise, share of the picture's mean; not in rms
  double seconds = 0.0;  ///< of the method; preparation included
};

struct GlossyPictureOptions {
  int width = 1280;
  int height = 800;
  int stride = 24;             ///< every so many pixels both ways are compared
  int samples = 16;            ///< per pixel
  std::uint32_t paths = 1024;  ///< of the path tracer per pixel, half of what is traced
  float probe_spacing = 2.0F;  ///< m
  int map_side = 64;
  int directions = 1024;  ///< over the sphere, that receivers gather from
  std::uint64_t seed = 1;
};

/// One picture by every method. All use `illumination` for what surfaces send and the same samples
/// of the same pixels; rays are those of render::renderView. Pixels with a luminaire in them are
/// left out. The path tracer traces twice: the mean product of both differences is the squared
/// error without either's noise.
///
/// Errors: the camera's; cancelled.
Result<std::vector<GlossyPictureRow>> measureGlossyPictures(
    const render::ViewScene& scene, const render::Illumination& illumination,
    const reference::ReferenceScene& reference, const scene::Camera& camera,
    const GlossyPictureOptions& options, const Job& job = {});

/// camera,method,part,...; a header and a row per element.
std::string formatGlossyPictureRows(const std::vector<GlossyPictureRow>& rows);

}  // namespace soffit::design
