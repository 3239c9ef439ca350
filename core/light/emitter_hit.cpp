// SPDX-License-Identifier: MIT
#include "core/light/emitter_hit.h"

#include "core/math/sampling.h"
#include "core/sh/polygon_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::light {
namespace {

constexpr double kGrazing = 1e-4;

/// Is `point`, in the plane of the outline, inside it? Crossings of a half line, in the plane's two
/// larger coordinates.
bool insideOutline(const std::vector<dvec3>& outline, const dvec3& normal, const dvec3& point) {
  const dvec3 size = glm::abs(normal);
  const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int a = (drop + 1) % 3, b = (drop + 2) % 3;
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const dvec3& p = outline[i];
    const dvec3& q = outline[j];
    if ((p[b] > point[b]) == (q[b] > point[b])) continue;
    const double crossing = p[a] + (point[b] - p[b]) / (q[b] - p[b]) * (q[a] - p[a]);
    if (point[a] < crossing) inside = !inside;
  }
  return inside;
}

/// The plane through `on` with the emitter's side, if the probe sees that side.
std::optional<EmitterHit> hitPlane(const Emitter& emitter, const dvec3& on, const dvec3& normal,
                                   const dvec3& probe, const dvec3& direction) {
  const double facing = -glm::dot(normal, direction);
  if (std::abs(facing) < kGrazing || (facing < 0.0 && !emitter.twoSided())) return std::nullopt;
  const double t = -glm::dot(on - probe, normal) / facing;
  if (!(t > 0.0)) return std::nullopt;
  return EmitterHit{t, facing > 0.0 ? normal : -normal};
}

std::optional<EmitterHit> hitPlanar(const Emitter& e, const dvec3& probe, const dvec3& direction) {
  const dvec3& on = e.disk ? e.position : e.outline[0];
  auto hit = hitPlane(e, on, e.normal, probe, direction);
  if (!hit) return hit;
  const dvec3 point = probe + hit->t * direction;
  const bool inside = e.disk ? glm::distance(point, e.position) <= e.radius
                             : insideOutline(e.outline, e.normal, point);
  return inside ? hit : std::nullopt;
}

std::optional<EmitterHit> hitSphere(const Emitter& e, const dvec3& probe, const dvec3& direction) {
  const dvec3 to = e.position - probe;
  const double along = glm::dot(to, direction);
  const dvec3 beside = to - along * direction;
  const double depth2 = e.radius * e.radius - glm::dot(beside, beside);
  if (depth2 <= 0.0 || glm::dot(to, to) <= e.radius * e.radius || along <= 0.0) return std::nullopt;
  const double t = along - std::sqrt(depth2);
  return EmitterHit{t, glm::normalize(t * direction - to)};
}

/// The lateral surface from outside; through an open end only its dark inside is seen.
std::optional<EmitterHit> hitTube(const Emitter& e, const EmitterPart& part, const dvec3& probe,
                                  const dvec3& direction) {
  const dvec3 to = e.position - probe;
  const double slant = glm::dot(direction, e.axis);
  const double shift = glm::dot(to, e.axis);
  const dvec3 d = direction - slant * e.axis;
  const dvec3 c = to - shift * e.axis;
  const double dd = glm::dot(d, d), dc = glm::dot(d, c);
  const double outside = glm::dot(c, c) - e.radius * e.radius;
  const double root2 = dc * dc - dd * outside;
  if (dd < 1e-12 || root2 <= 0.0 || outside <= 0.0) return std::nullopt;
  const double t = (dc - std::sqrt(root2)) / dd;
  const double place = t * slant - shift;
  if (!(t > 0.0) || place < part.begin || place >= part.end) return std::nullopt;
  return EmitterHit{t, glm::normalize(t * d - c)};
}

std::optional<EmitterHit> hitTriangle(const Emitter& e, std::size_t triangle, const dvec3& probe,
                                      const dvec3& direction) {
  const dvec3 a = e.corners[3 * triangle] - probe;
  const dvec3 b = e.corners[3 * triangle + 1] - probe;
  const dvec3 c = e.corners[3 * triangle + 2] - probe;
  const auto hit =
      hitPlane(e, e.corners[3 * triangle], e.triangle_normals[triangle], probe, direction);
  if (!hit) return hit;
  // Volumes with the three edges; one that is shared by two triangles has opposite signs in them,
  // so that no line of sight slips through between or counts twice, but for exact zeros: those
  // belong to the edge whose cross product comes first in the order of its coordinates.
  const auto side = [&direction](const dvec3& p, const dvec3& q) {
    const dvec3 normal = glm::cross(p, q);
    const double volume = glm::dot(direction, normal);
    if (volume != 0.0) return volume > 0.0;
    for (int i = 0; i < 3; ++i) {
      if (normal[i] != 0.0) return normal[i] > 0.0;
    }
    return false;
  };
  const bool ab = side(a, b);
  return ab == side(b, c) && ab == side(c, a) ? hit : std::nullopt;
}

EmitterPart ballAround(std::span<const dvec3> points, std::size_t triangle) {
  dvec3 lo = points[0], hi = points[0];
  for (const dvec3& p : points) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  return {0.5 * (lo + hi), 0.5 * glm::distance(lo, hi), triangle};
}

/// Sections about as long as four radii, 16 at most: balls around them are close.
std::vector<EmitterPart> sectionsOf(const Emitter& e) {
  const double wanted = std::ceil(0.5 * e.half_length / e.radius);
  const int count = static_cast<int>(std::clamp(wanted, 1.0, 16.0));
  const double half = e.half_length / count;
  std::vector<EmitterPart> sections;
  for (int i = 0; i < count; ++i) {
    const double middle = (2.0 * i + 1.0) * half - e.half_length;
    sections.push_back({.center = e.position + middle * e.axis,
                        .radius = std::hypot(half, e.radius),
                        .begin = middle - half,
                        .end = middle + half});
  }
  return sections;
}

/// The disk's polygon, counter-clockwise seen from its emitting side.
std::array<dvec3, 128> rimOf(const Emitter& e) {
  std::array<dvec3, 128> rim;
  dvec3 u, v;
  orthonormalBasis(e.normal, u, v);
  const double step = 2.0 * kPi / static_cast<double>(rim.size());
  const double radius = e.radius * std::sqrt(step / std::sin(step));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double phi = step * static_cast<double>(i);
    rim[i] = e.position + radius * (std::cos(phi) * u + std::sin(phi) * v);
  }
  return rim;
}

double oneOrBothSides(const Emitter& e, double solid_angle) {
  return e.twoSided() ? std::abs(solid_angle) : std::max(0.0, solid_angle);
}

}  // namespace

std::vector<EmitterPart> partsOf(const Emitter& e) {
  switch (e.kind) {
    case EmitterKind::point:
      return {};
    case EmitterKind::planar:
      if (e.disk) return {{e.position, e.radius}};
      return {ballAround(e.outline, 0)};
    case EmitterKind::sphere:
      return {{e.position, e.radius}};
    case EmitterKind::tube:
      return sectionsOf(e);
    case EmitterKind::mesh:
      break;
  }
  std::vector<EmitterPart> parts;
  for (std::size_t t = 0; t < e.triangle_normals.size(); ++t) {
    parts.push_back(ballAround(std::span(e.corners).subspan(3 * t, 3), t));
  }
  return parts;
}

std::optional<double> solidAngleOf(const Emitter& e, const EmitterPart& part, const dvec3& probe) {
  switch (e.kind) {
    case EmitterKind::planar:
      if (e.disk) return oneOrBothSides(e, sh::polygonSolidAngle(rimOf(e), probe));
      return oneOrBothSides(e, sh::polygonSolidAngle(e.outline, probe));
    case EmitterKind::sphere: {
      const double sine = e.radius / glm::distance(e.position, probe);
      if (sine >= 1.0) return 0.0;
      return 2.0 * kPi * sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
    }
    case EmitterKind::mesh: {
      const auto corners = std::span(e.corners).subspan(3 * part.triangle, 3);
      return oneOrBothSides(e, sh::polygonSolidAngle(corners, probe));
    }
    case EmitterKind::tube:
    case EmitterKind::point:
      break;
  }
  return std::nullopt;
}

std::optional<EmitterHit> hitPart(const Emitter& emitter, const EmitterPart& part,
                                  const dvec3& probe, const dvec3& direction) {
  switch (emitter.kind) {
    case EmitterKind::planar:
      return hitPlanar(emitter, probe, direction);
    case EmitterKind::sphere:
      return hitSphere(emitter, probe, direction);
    case EmitterKind::tube:
      return hitTube(emitter, part, probe, direction);
    case EmitterKind::mesh:
      return hitTriangle(emitter, part.triangle, probe, direction);
    case EmitterKind::point:
      break;
  }
  return std::nullopt;
}

}  // namespace soffit::light
