// SPDX-License-Identifier: MIT
#include "core/render/engine_light.h"

#include "core/relight/bodies.h"
#include "core/relight/direct_light.h"
#include "core/relight/outdoors.h"

#include <algorithm>

namespace soffit::render {
namespace {

/// The greatest area of some texels, m^2.
float widest(const transfer::Texels& texels,
             const std::array<std::uint32_t, transfer::Texels::kMostAround>& slots, int count) {
  float most = 0.0F;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    most = std::max(most, texels.area[slots[k]]);
  }
  return most;
}

}  // namespace

EngineLight::EngineLight(const std::shared_ptr<const relight::Lighting>& lighting)
    : EngineLight(lighting, lighting->indirectTotal()) {}

Result<std::shared_ptr<const EngineLight>> EngineLight::withThrownLight(
    std::shared_ptr<const relight::Lighting> lighting, const ViewScene& scene,
    const ThrownLightOptions& options, const Job& job) {
  if (!scene.hasSpecular()) return std::make_shared<const EngineLight>(std::move(lighting));
  const auto thrown = thrownLight(scene, *lighting, options, job);
  if (!thrown) return thrown.error();
  std::vector<scene::Material> matte = scene.materials();
  for (scene::Material& material : matte) material.specular = 0.0;
  auto indirect = lighting->reflectedUnder(*lighting->solver().repainted(matte), *thrown);
  if (!indirect) return std::make_shared<const EngineLight>(std::move(lighting));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<float>& more = (*thrown)[c];
    for (std::size_t s = 0; s < more.size(); ++s) (*indirect)[c][s] += more[s];
  }
  return std::shared_ptr<const EngineLight>(
      new EngineLight(std::move(lighting), std::move(*indirect)));
}

EngineLight::EngineLight(std::shared_ptr<const relight::Lighting> lighting,
                         relight::Planes indirect)
    : lighting_(std::move(lighting)), indirect_(std::move(indirect)) {
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
  direct_ = lighting_->total();
  const relight::Planes reflected = lighting_->indirectTotal();
  const relight::Planes& sky = lighting_->skyDirect();
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < direct_[c].size(); ++s) {
      const float other = reflected[c][s] + (sky[c].empty() ? 0.0F : sky[c][s]);
      direct_[c][s] = std::max(direct_[c][s] - other, 0.0F);
    }
  }
  if (lighting_->environment() == nullptr) return;
  // The sky is as smooth as reflected light and shown from the texels with it; what shines from one
  // point, the sun, is found for each point of the picture.
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < indirect_[c].size(); ++s) {
      indirect_[c][s] += lighting_->skyDirect()[c][s];
    }
  }
  for (const daylight::Spot& spot : lighting_->environment()->spots()) {
    const light::Emitter disc = relight::farDisc(spot, lighting_->solver().scene().mesh->bounds());
    lamps_.push_back(
        {light::PreparedLight(disc), lighting_->allBodies(), vec3(spot.normal_illuminance)});
  }
}

void EngineLight::computeDirect(std::span<const SurfacePoint> points,
                                std::span<vec3> direct) const {
  const transfer::StaticScene& scene = lighting_->solver().scene();
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<std::size_t> which;
  positions.reserve(points.size());
  normals.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(direct[i].x < 0.0F)) continue;
    positions.push_back(points[i].position);
    normals.push_back(points[i].shading_normal);
    which.push_back(i);
    direct[i] = vec3(0.0F);
  }
  if (which.empty()) return;
  const light::Receivers receivers = light::makeReceivers(positions, normals, 256);
  std::vector<float> lux(receivers.slotCount());
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  for (const Lamp& lamp : lamps_) {
    relight::directLight(scene, lamp.prepared, receivers, lamp.bodies, lux, lit);
    if (std::none_of(lit.begin(), lit.end(), [](std::uint8_t l) { return l != 0; })) continue;
    for (std::size_t k = 0; k < which.size(); ++k)
      direct[which[k]] += lux[receivers.slot_of[k]] * lamp.weight;
  }
}

void EngineLight::evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                           std::span<vec3> indirect) const {
  const transfer::StaticScene& scene = lighting_->solver().scene();
  const transfer::Texels& texels = lighting_->solver().operators().texels;
  // Below zero: still to be computed.
  std::fill(direct.begin(), direct.end(), vec3(-1.0F));
  std::vector<std::size_t> outdoor;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
    std::array<float, transfer::Texels::kMostAround> weights{};
    const bool front = glm::dot(p.normal, scene.normals[p.triangle]) > 0.0F;
    const int count =
        texels.slotCount() == 0 ? 0 : texels.around(p.triangle, front, p.position, slots, weights);
    const auto interpolated = [&](const relight::Planes& planes) {
      vec3 sum(0.0F);
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        sum += weights[k] * vec3(planes[0][slots[k]], planes[1][slots[k]], planes[2][slots[k]]);
      }
      return sum;
    };
    indirect[i] = interpolated(indirect_);
    if (count > 0 && p.blur > 0.0F && p.blur * p.blur >= widest(texels, slots, count)) {
      direct[i] = glm::max(interpolated(direct_), vec3(0.0F));
    }
    if (count == 0 && lighting_->environment() != nullptr) outdoor.push_back(i);
  }
  computeDirect(points, direct);
  // Outside walls, which nothing but the void sees, have no texels: their sky is found here.
  if (outdoor.empty()) return;
  std::vector<vec3> at;
  std::vector<vec3> facing;
  for (const std::size_t i : outdoor) {
    at.push_back(points[i].position);
    facing.push_back(points[i].shading_normal);
  }
  const daylight::OpenSky sky(at, facing, scene.caster, scene.panes.get(),
                              {.coarse = 16, .levels = 2});
  const std::vector<vec3> e = sky.illuminance(*lighting_->environment());
  for (std::size_t k = 0; k < outdoor.size(); ++k) indirect[outdoor[k]] += e[k];
}

}  // namespace soffit::render
