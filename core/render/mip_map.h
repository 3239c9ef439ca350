// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/scene/material.h"

#include <vector>

namespace soffit::render {

/// A texture with its reduced copies (box-filtered, Williams 1983): bilinear, repeated, and
/// without moiré at a distance.
class MipMap {
 public:
  /// image: 3 channels, row 0 at the top, at least one pixel.
  explicit MipMap(const scene::Image& image);

  /// The mean about uv over `width` (in texels of the full picture, trilinear between the
  /// copies). u to the right, v up: (0, 0) is the lower left corner. uv that is not finite counts
  /// as (0, 0).
  [[nodiscard]] vec3 at(const vec2& uv, float width) const;

  /// Texels of the full picture, for converting lengths in uv.
  [[nodiscard]] vec2 size() const;

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<vec3> texels;
    [[nodiscard]] vec3 bilinear(const vec2& uv) const;
  };
  static Level halved(const Level& level);
  std::vector<Level> levels_;
};

}  // namespace soffit::render
