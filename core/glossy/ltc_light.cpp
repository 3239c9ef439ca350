// SPDX-License-Identifier: MIT
#include "core/glossy/ltc_light.h"

#include "core/light/polygon_irradiance.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

constexpr int kCorners = 24;

/// Sutherland & Hodgman 1974 against z > 0. A polygon that is not convex keeps edges along the
/// horizon that run forth and back, and so add nothing.
std::vector<dvec3> aboveHorizon(std::span<const dvec3> corners) {
  std::vector<dvec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3& a = corners[i];
    const dvec3& b = corners[(i + 1) % corners.size()];
    if (a.z > 0.0) kept.push_back(a);
    if ((a.z > 0.0) != (b.z > 0.0)) kept.push_back(a + a.z / (a.z - b.z) * (b - a));
  }
  return kept;
}

/// A regular polygon with the area of a disk, counter-clockwise about `axis`.
std::vector<dvec3> disk(const dvec3& center, const dvec3& axis, double radius) {
  dvec3 t(0.0), b(0.0);
  orthonormalBasis(axis, t, b);
  const double step = 2.0 * kPi / kCorners;
  const double reach = radius * std::sqrt(step / std::sin(step));
  std::vector<dvec3> corners;
  corners.reserve(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    corners.push_back(center + reach * (std::cos(step * i) * t + std::sin(step * i) * b));
  }
  return corners;
}

std::vector<std::vector<dvec3>> sphereOutline(const light::Emitter& e, const dvec3& p) {
  const dvec3 d = p - e.position;
  const double distance = glm::length(d);
  if (distance <= e.radius) return {};
  // The circle of contact: sin = r / distance at the eye.
  const double sine = e.radius / distance;
  const double cosine = std::sqrt(1.0 - sine * sine);
  return {disk(e.position + d * (sine * sine), d / distance, e.radius * cosine)};
}

std::vector<std::vector<dvec3>> tubeOutline(const light::Emitter& e, const dvec3& p) {
  const dvec3 d = p - e.position;
  const dvec3 across = d - glm::dot(d, e.axis) * e.axis;
  const double distance = glm::length(across);
  if (distance <= e.radius) return {};
  const dvec3 v = across / distance;
  const dvec3 w = glm::cross(e.axis, v);
  // Tangent lines touch where the radius is square to the line of sight: cos = r / distance.
  const double c = e.radius / distance;
  const double s = std::sqrt(1.0 - c * c);
  const dvec3 right = e.position + e.radius * (c * v + s * w);
  const dvec3 left = e.position + e.radius * (c * v - s * w);
  const dvec3 along = e.half_length * e.axis;
  return {{right - along, right + along, left + along, left - along}};
}

std::vector<std::vector<dvec3>> planarOutline(const light::Emitter& e, const dvec3& p) {
  std::vector<dvec3> corners = e.disk ? disk(e.position, e.normal, e.radius) : e.outline;
  const double side = glm::dot(p - corners.front(), e.normal);
  if (side == 0.0 || (side < 0.0 && !e.twoSided())) return {};
  if (side < 0.0) std::reverse(corners.begin(), corners.end());
  return {corners};
}

std::vector<std::vector<dvec3>> meshOutlines(const light::Emitter& e, const dvec3& p) {
  std::vector<std::vector<dvec3>> facing;
  for (std::size_t k = 0; k < e.triangle_normals.size(); ++k) {
    const dvec3* corner = e.corners.data() + 3 * k;
    if (glm::dot(p - corner[0], e.triangle_normals[k]) <= 0.0) continue;
    facing.push_back({corner[0], corner[1], corner[2]});
  }
  return facing;
}

}  // namespace

LobeFrame::LobeFrame(const dvec3& position, const dvec3& normal, const dvec3& to_eye, double alpha)
    : position_(position), ltc_(ltcAt(glm::dot(normal, to_eye), alpha)) {
  dvec3 t = to_eye - glm::dot(to_eye, normal) * normal;
  dvec3 b(0.0);
  if (glm::length(t) > 1.0e-9) {
    t = glm::normalize(t);
  } else {
    orthonormalBasis(normal, t, b);
  }
  b = glm::cross(normal, t);
  local_ = glm::transpose(dmat3(t, b, normal));
}

double LobeFrame::share(std::span<const dvec3> outline) const {
  std::vector<dvec3> corners;
  for (const dvec3& corner : outline) corners.push_back(local_ * (corner - position_));
  corners = aboveHorizon(corners);
  if (corners.size() < 3) return 0.0;
  for (dvec3& corner : corners) corner = ltc_.inverse * corner;
  return light::polygonIrradiance(corners, dvec3(0.0), dvec3(0.0, 0.0, 1.0)) / kPi;
}

std::vector<std::vector<dvec3>> facingOutlines(const light::Emitter& emitter, const dvec3& p) {
  switch (emitter.kind) {
    case light::EmitterKind::planar:
      return planarOutline(emitter, p);
    case light::EmitterKind::sphere:
      return sphereOutline(emitter, p);
    case light::EmitterKind::tube:
      return tubeOutline(emitter, p);
    case light::EmitterKind::mesh:
      return meshOutlines(emitter, p);
    case light::EmitterKind::point:
      break;
  }
  return {};
}

}  // namespace soffit::glossy
