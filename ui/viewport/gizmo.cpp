// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kReachPixels = 9.0;
/// An arrow within 8 degrees of the line of sight, or a plane within 8 degrees of edge on.
constexpr double kEdgeOn = 0.14;
/// No further away than this many times the distance to the start: near the horizon a pixel is a
/// kilometre.
constexpr double kFarthest = 30.0;

constexpr std::array kArrows{GizmoPart::x, GizmoPart::y, GizmoPart::z};
constexpr std::array kPlanes{GizmoPart::yz, GizmoPart::zx, GizmoPart::xy};

/// The point of the line at + s axis that is nearest to a ray.
std::optional<dvec3> onAxis(const dvec3& at, const dvec3& axis, const dvec3& eye,
                            const dvec3& ray) {
  const double b = glm::dot(axis, ray);
  const double det = 1.0 - b * b;
  if (det < 1e-6) return std::nullopt;
  const dvec3 w = at - eye;
  const double s = (b * glm::dot(ray, w) - glm::dot(axis, w)) / det;
  return at + s * axis;
}

}  // namespace

dvec3 axisOf(int axis) {
  dvec3 v(0.0);
  v[axis] = 1.0;
  return v;
}

GizmoPart freePart(const ViewCamera& camera) {
  if (!camera.isParallel()) return GizmoPart::free;
  constexpr std::array kAcross{GizmoPart::yz, GizmoPart::zx, GizmoPart::xy};
  return kAcross[static_cast<std::size_t>(camera.mainAxis())];
}

int axisIndexOf(GizmoPart part) {
  switch (part) {
    case GizmoPart::x:
    case GizmoPart::yz:
      return 0;
    case GizmoPart::y:
    case GizmoPart::zx:
      return 1;
    default:
      return 2;
  }
}

bool isAxis(GizmoPart part) {
  return part == GizmoPart::x || part == GizmoPart::y || part == GizmoPart::z;
}

double distanceToSegment(const dvec2& p, const dvec2& a, const dvec2& b) {
  const dvec2 d = b - a;
  const double t = glm::clamp(glm::dot(p - a, d) / std::max(glm::dot(d, d), 1e-12), 0.0, 1.0);
  return glm::length(p - (a + t * d));
}

std::optional<dvec3> onPlane(const dvec3& at, const dvec3& normal, const dvec3& eye,
                             const dvec3& ray) {
  const double cosine = glm::dot(ray, normal);
  if (std::abs(cosine) < 1e-4) return std::nullopt;
  const double t = glm::dot(at - eye, normal) / cosine;
  if (t <= 0.0) return std::nullopt;
  return eye + t * ray;
}

double Gizmo::arrowLength(const dvec3& at, const ViewCamera& camera, const dvec2& size) {
  const double depth = std::max(glm::dot(at - camera.position, camera.forward), 1e-3);
  return kArrowPixels * camera.pixelSize(depth, size);
}

bool Gizmo::isEdgeOn(GizmoPart part, const dvec3& at, const ViewCamera& camera) {
  if (part == GizmoPart::none || part == GizmoPart::free) return false;
  const double cosine = std::abs(glm::dot(camera.sightTo(at), axisOf(axisIndexOf(part))));
  return isAxis(part) ? cosine > std::sqrt(1.0 - kEdgeOn * kEdgeOn) : cosine < kEdgeOn;
}

GizmoPart Gizmo::partAt(const dvec3& at, const ViewCamera& camera, const dvec2& size,
                        const dvec2& mouse) {
  if (glm::dot(at - camera.position, camera.forward) <= 0.0) return GizmoPart::none;
  const double length = arrowLength(at, camera, size);
  const auto pixel = [&](const dvec3& p) { return dvec2(camera.project(p, size)); };
  GizmoPart best = GizmoPart::none;
  double nearest = kReachPixels;
  for (const GizmoPart part : kArrows) {
    if (isEdgeOn(part, at, camera)) continue;
    const dvec3 axis = axisOf(axisIndexOf(part));
    const double d =
        distanceToSegment(mouse, pixel(at + 0.15 * length * axis), pixel(at + 1.1 * length * axis));
    if (d < nearest) {
      nearest = d;
      best = part;
    }
  }
  if (best != GizmoPart::none) return best;
  const dvec3 eye = camera.rayOrigin(mouse, size);
  const dvec3 ray = camera.rayThrough(mouse, size);
  for (const GizmoPart part : kPlanes) {
    if (isEdgeOn(part, at, camera)) continue;
    const int k = axisIndexOf(part);
    const auto hit = onPlane(at, axisOf(k), eye, ray);
    if (!hit) continue;
    const dvec3 d = (*hit - at) / length;
    const double u = d[(k + 1) % 3];
    const double v = d[(k + 2) % 3];
    if (u > kPlaneFrom && u < kPlaneTo && v > kPlaneFrom && v < kPlaneTo) return part;
  }
  return GizmoPart::none;
}

Gizmo::Gizmo(GizmoPart part, const dvec3& at, const ViewCamera& camera, const dvec2& size,
             const dvec2& mouse)
    : part_(part), start_(at), last_(at) {
  const auto point = grip(camera, size, mouse);
  if (point) offset_ = at - *point;
}

std::optional<dvec3> Gizmo::grip(const ViewCamera& camera, const dvec2& size,
                                 const dvec2& mouse) const {
  const dvec3 eye = camera.rayOrigin(mouse, size);
  const dvec3 ray = camera.rayThrough(mouse, size);
  const dvec3 axis = axisOf(axisIndexOf(part_));
  return isAxis(part_) ? onAxis(start_, axis, eye, ray) : onPlane(start_, axis, eye, ray);
}

dvec3 Gizmo::moved(const ViewCamera& camera, const dvec2& size, const dvec2& mouse) {
  const auto point = grip(camera, size, mouse);
  const double reach = kFarthest * glm::length(start_ - camera.position);
  if (point && glm::length(*point - start_) < reach) last_ = *point + offset_;
  return last_;
}

}  // namespace soffit::ui
