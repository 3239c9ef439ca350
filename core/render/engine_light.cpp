// SPDX-License-Identifier: MIT
#include "core/render/engine_light.h"

#include "core/relight/bodies.h"

#include <algorithm>

namespace soffit::render {

EngineLight::EngineLight(std::shared_ptr<const relight::Lighting> lighting)
    : lighting_(std::move(lighting)), indirect_(lighting_->indirectTotal()) {
  const auto emitters = lighting_->emitters();
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (emitters[i].gain <= 0.0) continue;
    Lamp lamp{light::PreparedLight(emitters[i]), {}, vec3(emitters[i].gain * emitters[i].color)};
    for (std::size_t k = 0; k < emitters.size(); ++k) {
      if (k == i && emitters[k].kind != light::EmitterKind::mesh) continue;
      const auto body = relight::bodyBlockers(emitters[k]);
      lamp.bodies.insert(lamp.bodies.end(), body.begin(), body.end());
    }
    lamps_.push_back(std::move(lamp));
  }
}

void EngineLight::evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                           std::span<vec3> indirect) const {
  const transfer::StaticScene& scene = lighting_->solver().scene();
  const transfer::Texels& texels = lighting_->solver().operators().texels;
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  positions.reserve(points.size());
  normals.reserve(points.size());
  for (const SurfacePoint& p : points) {
    positions.push_back(p.position);
    normals.push_back(p.shading_normal);
  }
  std::fill(direct.begin(), direct.end(), vec3(0.0F));
  if (!points.empty()) {
    const light::Receivers receivers = light::makeReceivers(positions, normals, 256);
    std::vector<float> lux(receivers.slotCount());
    std::vector<std::uint8_t> lit(receivers.clusters.size());
    for (const Lamp& lamp : lamps_) {
      light::directIlluminance(lamp.prepared, receivers, scene.blockers,
                               {.epsilon = scene.epsilon, .bodies = lamp.bodies}, lux, lit);
      if (std::none_of(lit.begin(), lit.end(), [](std::uint8_t l) { return l != 0; })) continue;
      for (std::size_t i = 0; i < points.size(); ++i)
        direct[i] += lux[receivers.slot_of[i]] * lamp.weight;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
    std::array<float, transfer::Texels::kMostAround> weights{};
    const bool front = glm::dot(p.normal, scene.normals[p.triangle]) > 0.0F;
    const int count =
        texels.slotCount() == 0 ? 0 : texels.around(p.triangle, front, p.position, slots, weights);
    vec3 sum(0.0F);
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      sum += weights[at] *
             vec3(indirect_[0][slots[at]], indirect_[1][slots[at]], indirect_[2][slots[at]]);
    }
    indirect[i] = sum;
  }
}

}  // namespace soffit::render
