// SPDX-License-Identifier: MIT
#include "core/render/emitter_shape_hit.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace soffit::render {
namespace {

bool within(const PreciseRay& ray, double t) {
  return t > ray.t_min && t < ray.t_max;
}

/// Crossing number in the plane, along the two axes that the normal leaves largest.
bool insideOutline(const light::Emitter& e, const dvec3& p) {
  const dvec3 n = glm::abs(e.normal);
  const int drop = n.x > n.y ? (n.x > n.z ? 0 : 2) : (n.y > n.z ? 1 : 2);
  const int a = (drop + 1) % 3;
  const int b = (drop + 2) % 3;
  bool inside = false;
  for (std::size_t i = 0, j = e.outline.size() - 1; i < e.outline.size(); j = i++) {
    const dvec3& u = e.outline[i];
    const dvec3& v = e.outline[j];
    if ((u[b] > p[b]) == (v[b] > p[b])) continue;
    if (p[a] < (v[a] - u[a]) * (p[b] - u[b]) / (v[b] - u[b]) + u[a]) inside = !inside;
  }
  return inside;
}

std::optional<ShapeHit> hitPlanar(const light::Emitter& e, const PreciseRay& ray) {
  const double cosine = glm::dot(e.normal, ray.direction);
  if (cosine == 0.0) return std::nullopt;
  const dvec3 anchor = e.disk ? e.position : e.outline.front();
  const double t = glm::dot(anchor - ray.origin, e.normal) / cosine;
  if (!within(ray, t)) return std::nullopt;
  const bool emits = cosine < 0.0 || e.twoSided();
  if (!emits && !e.casts_shadow) return std::nullopt;
  const dvec3 p = ray.origin + t * ray.direction;
  const dvec3 d = p - anchor;
  const bool inside = e.disk ? glm::dot(d, d) <= e.radius * e.radius : insideOutline(e, p);
  if (!inside) return std::nullopt;
  return ShapeHit{t, e.normal, emits && e.gain > 0.0};
}

/// The two roots of a t^2 + 2 b t + c = 0, ascending.
std::optional<std::array<double, 2>> roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (a <= 0.0 || discriminant < 0.0) return std::nullopt;
  const double s = std::sqrt(discriminant);
  return std::array<double, 2>{(-b - s) / a, (-b + s) / a};
}

std::optional<ShapeHit> hitSphere(const light::Emitter& e, const PreciseRay& ray) {
  const dvec3 d = ray.origin - e.position;
  const auto found = roots(1.0, glm::dot(d, ray.direction), glm::dot(d, d) - e.radius * e.radius);
  if (!found) return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k) {
    const double t = (*found)[k];
    const bool outside = k == 0;  // enters the ball: its lit outside is seen
    if (!within(ray, t) || (!outside && !e.casts_shadow)) continue;
    return ShapeHit{t, (d + t * ray.direction) / e.radius, outside && e.gain > 0.0};
  }
  return std::nullopt;
}

std::optional<ShapeHit> hitTube(const light::Emitter& e, const PreciseRay& ray) {
  const dvec3 d = ray.origin - e.position;
  const double along_d = glm::dot(d, e.axis);
  const double along_v = glm::dot(ray.direction, e.axis);
  const dvec3 dp = d - along_d * e.axis;
  const dvec3 vp = ray.direction - along_v * e.axis;
  std::optional<ShapeHit> best;
  const auto offer = [&](double t, const dvec3& normal, bool emits) {
    if (within(ray, t) && (!best || t < best->t)) best = ShapeHit{t, normal, emits};
  };
  if (const auto found =
          roots(glm::dot(vp, vp), glm::dot(dp, vp), glm::dot(dp, dp) - e.radius * e.radius)) {
    for (std::size_t k = 0; k < 2; ++k) {
      const double t = (*found)[k];
      const bool outside = k == 0;
      if (std::abs(along_d + t * along_v) > e.half_length || (!outside && !e.casts_shadow))
        continue;
      offer(t, (dp + t * vp) / e.radius, outside && e.gain > 0.0);
    }
  }
  if (e.casts_shadow && along_v != 0.0) {
    for (const double end : {-e.half_length, e.half_length}) {
      const double t = (end - along_d) / along_v;
      const dvec3 off = dp + t * vp;
      if (glm::dot(off, off) <= e.radius * e.radius) offer(t, end > 0.0 ? e.axis : -e.axis, false);
    }
  }
  return best;
}

}  // namespace

std::optional<ShapeHit> hitShape(const light::Emitter& emitter, const PreciseRay& ray) {
  switch (emitter.kind) {
    case light::EmitterKind::planar:
      return hitPlanar(emitter, ray);
    case light::EmitterKind::sphere:
      return hitSphere(emitter, ray);
    case light::EmitterKind::tube:
      return hitTube(emitter, ray);
    case light::EmitterKind::point:
    case light::EmitterKind::mesh:
      break;
  }
  return std::nullopt;
}

}  // namespace soffit::render
