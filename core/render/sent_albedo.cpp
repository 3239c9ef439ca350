// SPDX-License-Identifier: MIT
#include "core/render/sent_albedo.h"

#include "core/relight/reflectance.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {

SentAlbedo::SentAlbedo(const ViewScene& scene) : lobe_(1, 0.0F) {
  std::vector<std::uint8_t> known(1, 0);
  for (std::uint32_t t = 0; t < scene.mesh().triangles.size(); ++t) {
    const std::uint32_t material = scene.materialIndex(t);
    if (material >= lobe_.size()) {
      lobe_.resize(material + 1, 0.0F);
      known.resize(material + 1, 0);
    }
    if (known[material] != 0) continue;
    known[material] = 1;
    const ViewMaterial& m = scene.material(t);
    if (m.f0 > 0.0F) {
      lobe_[material] = static_cast<float>(relight::lobeAlbedo(
          static_cast<double>(m.f0), std::sqrt(static_cast<double>(m.mean_alpha))));
    }
  }
}

}  // namespace soffit::render
