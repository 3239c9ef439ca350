// SPDX-License-Identifier: MIT
#include "core/render/live_probes.h"

#include "core/base/parallel.h"
#include "core/render/probe_places.h"
#include "core/render/sent_albedo.h"
#include "core/render/surface_sample.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr int kLeastSide = 16;
constexpr int kMostSide = 64;

/// The weights of a size are the same for every scene.
std::shared_ptr<const glossy::ReflectionLevels> levelsOf(int side) {
  static std::mutex mutex;
  static std::map<int, std::shared_ptr<const glossy::ReflectionLevels>> made;
  const std::scoped_lock lock(mutex);
  auto& levels = made[side];
  if (levels == nullptr) levels = std::make_shared<const glossy::ReflectionLevels>(side);
  return levels;
}

std::shared_ptr<const glossy::ProbeDepth> lookFar(const geometry::RayCaster& caster,
                                                  const vec3& position) {
  static const sh::SphereSamples around = sh::cubeSamples(LiveProbes::kDepthSide);
  std::vector<geometry::Ray> rays;
  rays.reserve(around.size());
  for (const dvec3& d : around.directions) rays.push_back({position, 0.0F, vec3(d)});
  std::vector<geometry::Hit> hits(rays.size());
  caster.closest(rays, hits, true);
  std::vector<float> distances;
  distances.reserve(hits.size());
  for (const geometry::Hit& hit : hits) distances.push_back(hit.t);
  return std::make_shared<const glossy::ProbeDepth>(LiveProbes::kDepthSide, distances);
}

int sideFor(float alpha) {
  int side = kLeastSide;
  while (side < kMostSide && 2.0F / static_cast<float>(side) > alpha) side *= 2;
  return side;
}

}  // namespace

std::shared_ptr<const LiveProbes> LiveProbes::make(const ViewScene& scene,
                                                   const transfer::Texels& texels, const Job& job) {
  if (!scene.hasSpecular()) return nullptr;
  std::vector<ReflectingPiece> pieces;
  float sharpest = 1.0F;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const ViewMaterial& material = scene.material(texels.triangle[s]);
    if (material.f0 <= 0.0F || texels.area[s] <= 0.0F) continue;
    sharpest = std::min(sharpest, material.least_alpha);
    pieces.push_back({texels.receivers.position(s), texels.receivers.normal(s), texels.area[s]});
  }
  const std::vector<vec3> places = probePlaces(
      scene.caster(), pieces, kMostProbes, scene.outside({0.0F, 0.0F, 1.0F}, false).has_value());
  if (places.empty() || job.cancelled()) return nullptr;
  auto made = std::shared_ptr<LiveProbes>(new LiveProbes());
  made->room_ = scene.mesh().bounds();
  const int side = sideFor(sharpest);
  made->levels_ = levelsOf(side);
  made->directions_ = sh::cubeSamples(side);
  made->probes_.resize(places.size());
  const SentAlbedo albedo(scene);
  parallelFor(places.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      made->probes_[i] = look(scene, albedo, texels, places[i], made->directions_, side);
    }
  });
  if (job.cancelled()) return nullptr;
  return made;
}

LiveProbes::Probe LiveProbes::look(const ViewScene& scene, const SentAlbedo& albedo,
                                   const transfer::Texels& texels, const vec3& position,
                                   const sh::SphereSamples& directions, int side) {
  Probe probe;
  probe.position = position;
  std::vector<geometry::Ray> rays;
  for (const dvec3& d : directions.directions) rays.push_back({position, 0.0F, vec3(d)});
  std::vector<geometry::Hit> hits(rays.size());
  scene.caster().closest(rays, hits);
  probe.depth = lookFar(scene.caster(), position);
  probe.sight = std::make_shared<const glossy::ProbeSight>(*probe.depth);
  probe.first.push_back(0);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    probe.albedo.emplace_back(hits[k].valid() ? 0.0F : -1.0F);
    if (hits[k].valid()) {
      const SurfaceSample seen =
          sampleSurface(scene, rays[k], hits[k], {.spread = 2.0F / static_cast<float>(side)});
      probe.albedo.back() = albedo.of(seen);
      std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
      std::array<float, transfer::Texels::kMostAround> weights{};
      const SurfacePoint& p = seen.point;
      const bool front = glm::dot(p.normal, scene.normal(p.triangle)) > 0.0F;
      const int count = texels.around(p.triangle, front, p.position, slots, weights);
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        probe.slots.push_back(slots[i]);
        probe.weights.push_back(weights[i]);
      }
    }
    probe.first.push_back(static_cast<std::uint32_t>(probe.slots.size()));
  }
  return probe;
}

LitProbe LiveProbes::lit(const Probe& probe, const relight::Planes& lux,
                         const daylight::Environment* outside) const {
  std::vector<vec3> radiance(probe.albedo.size(), vec3(0.0F));
  for (std::size_t k = 0; k < radiance.size(); ++k) {
    vec3 sum(0.0F);
    for (std::uint32_t i = probe.first[k]; i < probe.first[k + 1]; ++i) {
      const std::uint32_t s = probe.slots[i];
      sum += probe.weights[i] * vec3(lux[0][s], lux[1][s], lux[2][s]);
    }
    if (probe.albedo[k].x >= 0.0F) {
      radiance[k] = probe.albedo[k] * glm::max(sum, vec3(0.0F)) / kPiF;
    } else if (outside != nullptr) {
      radiance[k] = vec3(outside->radiance(directions_.directions[k]));
    }
  }
  return {probe.position, probe.depth, probe.sight, glossy::ReflectionMap(levels_, radiance)};
}

std::shared_ptr<const LitProbes> LiveProbes::light(const relight::Planes& lux,
                                                   std::vector<LitLamp> lamps,
                                                   const daylight::Environment* outside) const {
  std::vector<std::optional<LitProbe>> made(probes_.size());
  parallelFor(probes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) made[i].emplace(lit(probes_[i], lux, outside));
  });
  std::vector<LitProbe> probes;
  probes.reserve(made.size());
  for (auto& probe : made) probes.push_back(std::move(*probe));
  return std::make_shared<const LitProbes>(room_, std::move(probes), std::move(lamps));
}

std::vector<vec3> LiveProbes::places() const {
  std::vector<vec3> places;
  for (const Probe& probe : probes_) places.push_back(probe.position);
  return places;
}

std::size_t LiveProbes::bytes() const {
  std::size_t sum = 0;
  for (const Probe& p : probes_) {
    sum += p.depth->rimmed().size() * sizeof(float) + p.sight->rimmed().size() * sizeof(vec2) +
           p.albedo.size() * (sizeof(vec3) + sizeof(std::uint32_t)) +
           p.slots.size() * (sizeof(std::uint32_t) + sizeof(float));
  }
  return sum;
}

}  // namespace soffit::render
