// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/math/box.h"
#include "core/reference/reference_scene.h"
#include "core/render/illumination.h"
#include "core/render/lit_probes.h"
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
  std::string part;  ///< "picture", the material of the pixels and its roughness, "matte surfaces"
  std::size_t pixels = 0;
  double mean = 0.0;       ///< of the path tracer, cd/m2
  double rms = 0.0;        ///< error, share of the picture's mean
  double bias = 0.0;       ///< mean error, share of the picture's mean
  double rms_error = 0.0;  ///< standard error of rms, from the scatter between pixels
  double noise = 0.0;  ///< the path tracer's own RMS noise, share of the picture's mean; not in rms
  double seconds = 0.0;  ///< of the method; preparation included
};

struct GlossyPictureOptions {
  int width = 1280;
  int height = 800;
  int stride = 24;             ///< every so many pixels both ways are compared
  int samples = 16;            ///< per pixel
  std::uint32_t paths = 2048;  ///< of the path tracer per pixel, half of what is traced
  float probe_spacing = 2.0F;  ///< m
  int map_side = 64;
  int directions = 1024;  ///< over the sphere, that receivers gather from
  std::uint64_t seed = 1;
};

/// Where the diffuse light of a picture comes from.
struct PictureLights {
  const render::Illumination& quick;        ///< maps, harmonics
  const render::Illumination& best;         ///< rays: what final pictures take
  const render::LitProbes* live = nullptr;  ///< the viewport's reflections; null: left out
};

/// What was found: figures, and what they were made of.
struct GlossyPictures {
  std::vector<GlossyPictureRow> rows;
  std::string pixels;  ///< a CSV table: every pixel by every method and by the path tracer's halves
};

/// One picture by every method. All use the same samples of the same pixels; rays are those of
/// render::renderView. "matte alone" has no reflections: once by each light. Pixels with a
/// luminaire in them are left out. The path tracer traces twice: the mean product of both
/// differences is the squared error without either's noise. Diffuse light is judged in its parts as
/// well, straight from luminaires and reflected, over matte surfaces.
///
/// Errors: the camera's; cancelled.
Result<GlossyPictures> measureGlossyPictures(const render::ViewScene& scene,
                                             const PictureLights& lights,
                                             const reference::ReferenceScene& reference,
                                             const scene::Camera& camera,
                                             const GlossyPictureOptions& options,
                                             const Job& job = {});

/// camera,method,part,...; a header and a row per element.
std::string formatGlossyPictureRows(const std::vector<GlossyPictureRow>& rows);

}  // namespace soffit::design
