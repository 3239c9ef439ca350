// SPDX-License-Identifier: MIT
#include "core/design/surface_reading.h"

#include "core/relight/bodies.h"
#include "core/relight/direct_light.h"
#include "core/relight/outdoors.h"

#include <array>

namespace soffit::design {

light::Receivers toReceivers(std::span<const SurfaceReceiver> receivers) {
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  for (const SurfaceReceiver& r : receivers) {
    positions.emplace_back(r.position);
    normals.emplace_back(r.normal);
  }
  return light::makeReceivers(positions, normals, 64);
}

std::vector<light::MaskBlocker> bodiesAgainst(std::span<const light::Emitter> emitters,
                                              std::size_t i) {
  std::vector<light::MaskBlocker> out;
  for (std::size_t k = 0; k < emitters.size(); ++k) {
    if (k == i && emitters[k].kind != light::EmitterKind::mesh) continue;
    const auto body = relight::bodyBlockers(emitters[k]);
    out.insert(out.end(), body.begin(), body.end());
  }
  return out;
}

std::vector<dvec3> interpolateAt(const transfer::Texels& texels, const relight::Planes& planes,
                                 std::span<const SurfaceReceiver> receivers) {
  std::vector<dvec3> out(receivers.size(), dvec3(0.0));
  if (texels.slotCount() == 0) return out;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
    std::array<float, transfer::Texels::kMostAround> weights{};
    const SurfaceReceiver& r = receivers[i];
    const int count = texels.around(r.triangle, r.front, vec3(r.position), slots, weights);
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      for (std::size_t c = 0; c < 3; ++c) {
        out[i][static_cast<int>(c)] +=
            static_cast<double>(weights[at]) * static_cast<double>(planes[c][slots[at]]);
      }
    }
  }
  return out;
}

std::vector<relight::SensorLight> readSurfaces(const relight::Lighting& lighting,
                                               std::span<const SurfaceReceiver> receivers) {
  std::vector<relight::SensorLight> out(receivers.size());
  if (receivers.empty()) return out;
  const transfer::StaticScene& scene = lighting.solver().scene();
  const light::Receivers points = toReceivers(receivers);
  std::vector<float> lux(points.slotCount());
  std::vector<std::uint8_t> lit(points.clusters.size());
  const auto emitters = lighting.emitters();
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (emitters[i].gain <= 0.0) continue;
    const auto bodies = bodiesAgainst(emitters, i);
    relight::directLight(scene, light::PreparedLight(emitters[i]), points, bodies, lux, lit);
    const dvec3 weight = emitters[i].gain * emitters[i].color;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].direct += weight * static_cast<double>(lux[points.slot_of[k]]);
    }
  }
  if (const auto* environment = lighting.environment()) {
    const relight::Planes& sky = lighting.skyDirect();
    const auto direct = interpolateAt(lighting.solver().operators().texels, sky, receivers);
    for (std::size_t k = 0; k < out.size(); ++k) out[k].direct += direct[k];
    const auto bodies = lighting.allBodies();
    for (const daylight::Spot& spot : environment->spots()) {
      const light::Emitter disc = relight::farDisc(spot, scene.mesh->bounds());
      relight::directLight(scene, light::PreparedLight(disc), points, bodies, lux, lit);
      for (std::size_t k = 0; k < out.size(); ++k) {
        out[k].direct += static_cast<double>(lux[points.slot_of[k]]) * spot.normal_illuminance;
      }
    }
  }
  const std::vector<dvec3> indirect =
      interpolateAt(lighting.solver().operators().texels, lighting.indirectTotal(), receivers);
  for (std::size_t k = 0; k < out.size(); ++k) out[k].indirect = indirect[k];
  return out;
}

}  // namespace soffit::design
