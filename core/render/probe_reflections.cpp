// SPDX-License-Identifier: MIT
#include "core/render/probe_reflections.h"

#include "core/glossy/first_hits.h"
#include "core/render/sent_albedo.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr float kClearance = 0.2F;

}  // namespace

ProbeReflections::ProbeReflections(const ViewScene& scene, std::span<const vec3> probes,
                                   const Box& room,
                                   std::shared_ptr<const glossy::ReflectionLevels> levels)
    : room_(room), levels_(std::move(levels)) {
  const int side = levels_->pyramid().side();
  const auto samples = std::make_shared<const sh::SphereSamples>(sh::cubeSamples(side));
  const SentAlbedo albedo(scene);
  const glossy::FirstHits first(scene.caster(), probes, {}, samples);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    Probe probe;
    probe.position = probes[i];
    std::vector<float> distances;
    for (std::size_t k = 0; k < samples->size(); ++k) {
      const geometry::Hit& hit = first.hits(i)[k];
      distances.push_back(hit.t);
      if (!hit.valid()) continue;
      const geometry::Ray ray{probes[i], 0.0F, vec3(samples->directions[k])};
      const SurfaceSample seen =
          sampleSurface(scene, ray, hit, {.spread = 2.0F / static_cast<float>(side)});
      probe.places.push_back(seen.point);
      probe.albedo.push_back(albedo.of(seen));
      probe.texel.push_back(static_cast<std::uint32_t>(k));
    }
    probe.depth = std::make_shared<const glossy::ProbeDepth>(side, distances);
    probe.sight = std::make_shared<const glossy::ProbeSight>(*probe.depth);
    probes_.push_back(std::move(probe));
  }
}

std::size_t ProbeReflections::placeCount() const {
  std::size_t sum = 0;
  for (const Probe& probe : probes_) sum += probe.places.size();
  return sum;
}

void ProbeReflections::light(const Illumination& illumination) {
  const auto side = static_cast<std::size_t>(levels_->pyramid().side());
  std::vector<LitProbe> lit;
  for (const Probe& probe : probes_) {
    std::vector<vec3> direct(probe.places.size(), vec3(0.0F));
    std::vector<vec3> indirect(direct);
    illumination.evaluate(probe.places, direct, indirect);
    std::vector<vec3> radiance(6 * side * side, vec3(0.0F));
    for (std::size_t k = 0; k < probe.places.size(); ++k) {
      radiance[probe.texel[k]] = probe.albedo[k] * (direct[k] + indirect[k]) / kPiF;
    }
    lit.push_back(
        {probe.position, probe.depth, probe.sight, glossy::ReflectionMap(levels_, radiance)});
  }
  lit_.emplace(room_, std::move(lit));
}

vec3 ProbeReflections::reflected(const SurfaceSample& at, float f0, float alpha) const {
  if (!lit_) return vec3(0.0F);
  return lit_->reflected({at.point.position, at.point.shading_normal, at.to_eye}, f0, alpha);
}

std::vector<vec3> probeGrid(const ViewScene& scene, const Box& room, float spacing) {
  const vec3 size = room.size();
  const auto steps = [&](float length) {
    return std::max(1, static_cast<int>(std::lround(length / spacing)));
  };
  const int nx = steps(size.x);
  const int ny = steps(size.y);
  const sh::SphereSamples around = sh::cubeSamples(4);
  std::vector<vec3> probes;
  for (const float height : {1.0F / 3.0F, 2.0F / 3.0F}) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const vec3 share((static_cast<float>(i) + 0.5F) / static_cast<float>(nx),
                         (static_cast<float>(j) + 0.5F) / static_cast<float>(ny), height);
        const vec3 p = room.lo + share * size;
        const bool clear =
            std::none_of(around.directions.begin(), around.directions.end(), [&](const dvec3& d) {
              return scene.caster().occluded(geometry::Ray{p, 0.0F, vec3(d), kClearance});
            });
        if (clear) probes.push_back(p);
      }
    }
  }
  return probes;
}

}  // namespace soffit::render
