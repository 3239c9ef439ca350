// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::scene {

/// A picture in memory, linear, row 0 at the top, `channels` interleaved floats per pixel.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 3;
  std::vector<float> pixels;
};

struct Glass {
  double index = 1.52;
  double transmittance = 0.88;  ///< of the whole sheet at normal incidence
};

/// How a surface reflects; both sides alike.
struct Material {
  std::string name;
  dvec3 diffuse{0.5};       ///< diffuse albedo, linear Rec.709, 0..1
  double specular = 0.0;    ///< reflectance at normal incidence of a GGX lobe, Schlick toward 1
  double roughness = 0.5;   ///< GGX alpha = roughness squared; 0 is a mirror
  std::string diffuse_map;  ///< path relative to the project; multiplies `diffuse`
  std::string normal_map;
  std::string roughness_map;  ///< green channel, as stored, multiplies `roughness`
  std::shared_ptr<const Image>
      diffuse_image;                          ///< decoded to linear, 3 channels; null without a map
  std::shared_ptr<const Image> normal_image;  ///< as stored, 3 channels in 0..1; null without a map
  std::shared_ptr<const Image> roughness_image;  ///< as stored, 3 channels; null without a map
  std::optional<Glass> glass;
};

}  // namespace soffit::scene
