// SPDX-License-Identifier: MIT
#include "core/render/lit_probes.h"

#include "core/glossy/lobe_shape.h"

#include <algorithm>
#include <array>
#include <utility>

namespace soffit::render {

vec3 LitProbes::reflected(const ReflectingPoint& at, float f0, float alpha) const {
  if (f0 <= 0.0F) return vec3(0.0F);
  vec3 sum = probes_.empty() ? vec3(0.0F) : surfaces(at, f0, alpha);
  for (const LitLamp& lamp : lamps_) {
    sum += lampHighlight(lamp, at.position, at.normal, at.to_eye, f0, alpha);
  }
  return sum;
}

vec3 LitProbes::surfaces(const ReflectingPoint& at, float f0, float alpha) const {
  const vec3& p = at.position;
  const glossy::LobeShape shape = glossy::lobeShape(
      static_cast<double>(glm::dot(at.normal, at.to_eye)), static_cast<double>(alpha));
  // Both parts of the lobe with what they weigh.
  struct Part {
    vec3 axis;
    float alpha;
    float weight;
  };
  const auto partOf = [&](const glossy::RoundLobe& lobe, float weight) {
    return Part{glossy::lobeAxis(lobe, at.normal, at.to_eye), static_cast<float>(lobe.alpha),
                weight};
  };
  const std::array<Part, 2> parts{partOf(shape.base, f0 * static_cast<float>(shape.scale)),
                                  partOf(shape.rise, static_cast<float>(shape.bias))};
  const vec3 axis =
      glm::normalize(parts[0].weight * parts[0].axis + parts[1].weight * parts[1].axis);
  const float far = glossy::distanceToBox(room_, p, axis).value_or(room_.diagonal());

  // The heaviest in falling order, and the next one.
  std::array<std::pair<float, const LitProbe*>, kMostAtOnce + 1> chosen{};
  std::pair<float, const LitProbe*> nearest{-1.0F, nullptr};
  for (const LitProbe& probe : probes_) {
    const vec3 d = p - probe.position;
    const float distance = glm::length(d);
    const float near = 1.0F / (distance * distance + kNear);
    if (glm::dot(d, at.normal) >= 0.0F) continue;  // behind the surface
    if (near > nearest.first) nearest = {near, &probe};
    std::pair<float, const LitProbe*> candidate{near * probe.sight->of(d), &probe};
    for (auto& place : chosen) {
      if (candidate.first > place.first) std::swap(candidate, place);
    }
  }
  const float next = kNextShare * chosen.back().first;
  chosen.back() = {};
  for (auto& [weight, probe] : chosen) weight = std::max(0.0F, weight - next);
  if (chosen.front().second == nullptr) chosen.front() = nearest;
  if (chosen.front().second == nullptr) return vec3(0.0F);
  vec3 sum(0.0F);
  float weights = 0.0F;
  for (const auto& [weight, probe] : chosen) {
    if (probe == nullptr || weight <= 0.0F) continue;
    const float t = probe->depth->reach(probe->position, p, axis, far);
    for (const Part& part : parts) {
      const glossy::Lookup lookup = glossy::seenFrom(probe->position, p, part.axis, t);
      sum += weight * part.weight *
             probe->map.at(lookup.direction, std::min(part.alpha * lookup.width, 1.0F));
    }
    weights += weight;
  }
  return sum / weights;
}

}  // namespace soffit::render
