// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soffit::render {

/// What a picture measured, per pixel, row 0 at the top.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<vec3> radiance;  ///< linear Rec.709 whose luminance is cd/m^2
  std::vector<float> lux;      ///< illuminance of the surfaces in the pixel; 0 where there are none
  std::vector<float> surface;  ///< share of the pixel that shows surfaces, 0..1
  std::vector<float> lamp;     ///< share of the pixel that shows luminaires, 0..1
  std::vector<std::uint32_t> triangle;  ///< at the pixel's centre, or geometry::kNoTriangle

  Film() = default;
  Film(int w, int h)
      : width(w),
        height(h),
        radiance(count(), vec3(0.0F)),
        lux(count(), 0.0F),
        surface(count(), 0.0F),
        lamp(count(), 0.0F),
        triangle(count(), geometry::kNoTriangle) {}

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace soffit::render
