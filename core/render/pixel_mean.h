// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/luminance.h"
#include "core/math/vec.h"

namespace soffit::render {

/// The mean of a pixel's samples, with the weight of bright ones falling off (Reinhard 2002's
/// curve, applied and undone): L -> L / (1 + Y / white). Without it a pixel half covered by a
/// luminaire is as white as the luminaire, and its edge shows steps after tone mapping.
/// white = 0: the plain mean.
class PixelMean {
 public:
  explicit PixelMean(float white) : inverse_white_(white > 0.0F ? 1.0F / white : 0.0F) {}

  void add(const vec3& radiance) {
    sum_ += radiance / (1.0F + color::luminance(radiance) * inverse_white_);
    count_ += 1.0F;
  }
  [[nodiscard]] vec3 value() const {
    if (count_ == 0.0F) return vec3(0.0F);
    const vec3 mean = sum_ / count_;
    if (inverse_white_ == 0.0F) return mean;
    // The compressed luminance stays below white; rounding must not reach it.
    const float rest = 1.0F - color::luminance(mean) * inverse_white_;
    return mean / (rest > 1.0e-6F ? rest : 1.0e-6F);
  }

 private:
  vec3 sum_{0.0F};
  float count_ = 0.0F;
  float inverse_white_;
};

}  // namespace soffit::render
