// SPDX-License-Identifier: MIT
#include "core/render/light_aim.h"

#include "core/light/emitter_sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

using light::Emitter;
using light::EmitterKind;

bool isRound(const Emitter& e) {
  return e.kind == EmitterKind::sphere || e.kind == EmitterKind::tube;
}

/// The opposite point where this one is on the far half.
void turnTowards(const Emitter& e, const dvec3& origin, light::EmitterSample& sample) {
  const dvec3 center = sample.point - e.radius * sample.normal;  // of the sphere, or on the axis
  if (glm::dot(sample.normal, origin - center) >= 0.0) return;
  sample.normal = -sample.normal;
  sample.point = center + e.radius * sample.normal;
}

}  // namespace

double areaDensity(const Emitter& emitter) {
  return (isRound(emitter) ? 2.0 : 1.0) / emitter.area;
}

LightAim aimAt(const Emitter& emitter, const dvec3& origin, const vec2& u) {
  light::EmitterSample sample = light::sampleByArea(emitter, dvec2(u));
  if (isRound(emitter)) turnTowards(emitter, origin, sample);
  const dvec3 d = sample.point - origin;
  LightAim aim;
  aim.distance = glm::length(d);
  if (!(aim.distance > 0.0)) return aim;
  aim.direction = d / aim.distance;
  aim.normal = sample.normal;
  const double distance2 = aim.distance * aim.distance;
  if (emitter.kind == EmitterKind::point) {
    aim.intensity =
        vec3(emitter.color * (emitter.pointIntensity(-aim.direction) * emitter.gain / distance2));
  } else {
    const double cosine = std::max(std::abs(glm::dot(aim.normal, aim.direction)), 1.0e-6);
    aim.pdf = areaDensity(emitter) * distance2 / cosine;
  }
  return aim;
}

}  // namespace soffit::render
