// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/surface_sample.h"
#include "core/render/view_scene.h"

#include <vector>

namespace soffit::render {

/// What share of its light a surface sends on when it is seen in a rough reflection: its diffuse
/// albedo and, as if it were diffuse too, the hemispherical albedo of its lobe, as in the engine's
/// bounces (relight::lobeAlbedo()). Together at most 1.
class SentAlbedo {
 public:
  explicit SentAlbedo(const ViewScene& scene);
  [[nodiscard]] vec3 of(const SurfaceSample& sample) const {
    return glm::min(sample.albedo + vec3(lobe_[sample.material]), vec3(1.0F));
  }

 private:
  std::vector<float> lobe_;  ///< per material
};

}  // namespace soffit::render
