// SPDX-License-Identifier: MIT
#include "core/render/light_aim.h"

#include "core/light/emitter_sampling.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

using light::Emitter;
using light::EmitterKind;

/// The cone in which a sphere is seen: 1 - cos of its half angle, without cancellation far away.
double coneHeight(const Emitter& e, double distance2) {
  const double sin2 = e.radius * e.radius / distance2;
  return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

LightAim aimAtSphere(const Emitter& e, const dvec3& origin, const vec2& u) {
  const dvec3 d = e.position - origin;
  const double distance2 = glm::dot(d, d);
  if (distance2 <= e.radius * e.radius) return {};
  const double height = coneHeight(e, distance2);
  const double z = 1.0 - static_cast<double>(u.x) * height;
  const double s = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
  const double phi = 2.0 * kPi * static_cast<double>(u.y);
  const dvec3 axis = d / std::sqrt(distance2);
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(axis, t, b);
  LightAim aim;
  aim.direction = s * std::cos(phi) * t + s * std::sin(phi) * b + z * axis;
  const double middle = std::sqrt(distance2) * z;
  // Nearer of the two crossings; on the rim rounding may leave the root negative.
  aim.distance = middle - std::sqrt(std::max(0.0, e.radius * e.radius - distance2 * s * s));
  aim.normal = (aim.distance * aim.direction - d) / e.radius;
  aim.pdf = 1.0 / (2.0 * kPi * height);
  return aim;
}

/// The opposite point where this one is on the far half.
void turnTowards(const Emitter& tube, const dvec3& origin, light::EmitterSample& sample) {
  const dvec3 center = sample.point - tube.radius * sample.normal;  // on the axis
  if (glm::dot(sample.normal, origin - center) >= 0.0) return;
  sample.normal = -sample.normal;
  sample.point = center + tube.radius * sample.normal;
}

}  // namespace

double aimPdf(const Emitter& emitter, const dvec3& origin, const dvec3& direction, double distance,
              const dvec3& normal) {
  if (emitter.kind == EmitterKind::sphere) {
    const dvec3 d = emitter.position - origin;
    const double distance2 = glm::dot(d, d);
    return distance2 > emitter.radius * emitter.radius
               ? 1.0 / (2.0 * kPi * coneHeight(emitter, distance2))
               : 0.0;
  }
  const double share = emitter.kind == EmitterKind::tube ? 2.0 : 1.0;
  const double cosine = std::max(std::abs(glm::dot(normal, direction)), 1.0e-6);
  return share * distance * distance / (emitter.area * cosine);
}

LightAim aimAt(const Emitter& emitter, const dvec3& origin, const vec2& u) {
  if (emitter.kind == EmitterKind::sphere) return aimAtSphere(emitter, origin, u);
  light::EmitterSample sample = light::sampleByArea(emitter, dvec2(u));
  if (emitter.kind == EmitterKind::tube) turnTowards(emitter, origin, sample);
  const dvec3 d = sample.point - origin;
  LightAim aim;
  aim.distance = glm::length(d);
  if (!(aim.distance > 0.0)) return aim;
  aim.direction = d / aim.distance;
  aim.normal = sample.normal;
  if (emitter.kind == EmitterKind::point) {
    const double lux =
        emitter.pointIntensity(-aim.direction) * emitter.gain / (aim.distance * aim.distance);
    aim.intensity = vec3(emitter.color * lux);
  } else {
    aim.pdf = aimPdf(emitter, origin, aim.direction, aim.distance, aim.normal);
  }
  return aim;
}

}  // namespace soffit::render
