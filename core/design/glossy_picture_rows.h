// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/glossy_pictures.h"
#include "core/design/pixel_samples.h"
#include "core/reference/beams.h"
#include "core/scene/material.h"

#include <span>
#include <string>
#include <vector>

/// From pictures by several methods and the path tracer's to figures.
namespace soffit::design {

/// A picture by one method: luminance per pixel of PixelSamples.
struct PictureByMethod {
  std::string name;
  std::vector<double> luminance;
  std::vector<double> direct;  ///< of that, straight from luminaires; empty where not told apart
  double seconds = 0.0;
};

/// What pictures are held against.
struct PictureTruth {
  std::string camera;
  const PixelSamples& pixels;
  std::span<const scene::Material> materials;
  std::span<const reference::BeamEstimate> beams;  ///< one per pixel
};

/// A row per method for the whole picture, for each material that reflects, and for matte surfaces;
/// where a method tells its parts apart, two more for the parts of light on matte surfaces.
GlossyPictures judgePictures(const PictureTruth& truth,
                             const std::vector<PictureByMethod>& methods);

}  // namespace soffit::design
