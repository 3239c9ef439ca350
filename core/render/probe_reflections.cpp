// SPDX-License-Identifier: MIT
#include "core/render/probe_reflections.h"

#include "core/glossy/first_hits.h"
#include "core/glossy/lobe_shape.h"
#include "core/render/sent_albedo.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr std::size_t kMostProbes = 3;
/// How much farther than what a probe sees a point may be and still count as seen: texels are wide.
constexpr float kSeen = 1.05F;
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
    probe.depth.emplace(side, std::move(distances));
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
  for (Probe& probe : probes_) {
    std::vector<vec3> direct(probe.places.size(), vec3(0.0F));
    std::vector<vec3> indirect(direct);
    illumination.evaluate(probe.places, direct, indirect);
    std::vector<vec3> radiance(6 * side * side, vec3(0.0F));
    for (std::size_t k = 0; k < probe.places.size(); ++k) {
      radiance[probe.texel[k]] = probe.albedo[k] * (direct[k] + indirect[k]) / kPiF;
    }
    probe.map.emplace(levels_, radiance);
  }
}

vec3 ProbeReflections::reflected(const SurfaceSample& at, float f0, float alpha) const {
  if (probes_.empty() || f0 <= 0.0F) return vec3(0.0F);
  const vec3& normal = at.point.shading_normal;
  const vec3& p = at.point.position;
  const glossy::LobeShape shape = glossy::lobeShape(
      static_cast<double>(glm::dot(normal, at.to_eye)), static_cast<double>(alpha));
  // Both parts of the lobe (lobe_shape.h), with what they weigh.
  const std::array<glossy::RoundLobe, 2> parts{shape.base, shape.rise};
  const std::array<float, 2> weight_of{f0 * static_cast<float>(shape.scale),
                                       static_cast<float>(shape.bias)};
  std::array<std::pair<float, const Probe*>, kMostProbes> chosen{};
  std::pair<float, const Probe*> nearest{-1.0F, nullptr};
  for (const Probe& probe : probes_) {
    if (!probe.map) continue;
    const vec3 d = p - probe.position;
    const float distance = glm::length(d);
    const float weight = 1.0F / (distance * distance + 0.01F);
    if (weight > nearest.first) nearest = {weight, &probe};
    if (distance > kSeen * probe.depth->toward(d)) continue;
    const auto least = std::min_element(chosen.begin(), chosen.end());
    if (weight > least->first) *least = {weight, &probe};
  }
  vec3 sum(0.0F);
  float weights = 0.0F;
  const auto add = [&](float weight, const Probe& probe) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const vec3 axis = glossy::lobeAxis(parts[k], normal, at.to_eye);
      const float far = glossy::distanceToBox(room_, p, axis).value_or(room_.diagonal());
      const glossy::Lookup lookup = probe.depth->throughDepth(probe.position, p, axis, far);
      const float width = static_cast<float>(parts[k].alpha) * lookup.width;
      sum += weight * weight_of[k] * probe.map->at(lookup.direction, std::min(width, 1.0F));
    }
    weights += weight;
  };
  for (const auto& [weight, probe] : chosen) {
    if (probe != nullptr) add(weight, *probe);
  }
  if (weights <= 0.0F && nearest.second != nullptr) add(nearest.first, *nearest.second);
  if (weights <= 0.0F) return vec3(0.0F);
  return sum / weights;
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
