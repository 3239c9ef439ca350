// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo_turning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr int kSegments = 64;
constexpr double kReachPixels = 8.0;
/// Below this the plane of a ring is met too far away for an angle that the hand controls.
constexpr double kEndOn = 0.25;

dvec3 onRing(const dvec3& at, int axis, double radius, double phi) {
  return at +
         radius * (std::cos(phi) * axisOf((axis + 1) % 3) + std::sin(phi) * axisOf((axis + 2) % 3));
}

}  // namespace

GizmoPart Turning::partAt(const dvec3& at, const ViewCamera& camera, const dvec2& size,
                          const dvec2& mouse) {
  if (glm::dot(at - camera.position, camera.forward) <= 0.0) return GizmoPart::none;
  const double radius = kRingRadius * Gizmo::arrowLength(at, camera, size);
  GizmoPart best = GizmoPart::none;
  double nearest = 1e30;
  for (const GizmoPart part : {GizmoPart::x, GizmoPart::y, GizmoPart::z}) {
    for (int i = 0; i < kSegments; ++i) {
      const dvec3 a =
          camera.project(onRing(at, axisIndexOf(part), radius, 2.0 * kPi * i / kSegments), size);
      const dvec3 b = camera.project(
          onRing(at, axisIndexOf(part), radius, 2.0 * kPi * (i + 1) / kSegments), size);
      if (a.z <= 0.0 || b.z <= 0.0) continue;
      if (distanceToSegment(mouse, dvec2(a), dvec2(b)) > kReachPixels || a.z >= nearest) continue;
      nearest = a.z;
      best = part;
    }
  }
  return best;
}

Turning::Turning(GizmoPart ring, const dvec3& at, const ViewCamera& camera, const dvec2& size,
                 const dvec2& mouse)
    : axis_(axisIndexOf(ring)), at_(at), start_(mouse) {
  const dvec3 to_eye = -camera.sightTo(at);
  end_on_ = std::abs(glm::dot(to_eye, axisOf(axis_))) < kEndOn;
  if (end_on_) {
    // The middle of the ring that looks at the eye, and where it runs to on the screen.
    const double radius = kRingRadius * Gizmo::arrowLength(at, camera, size);
    const double phi = std::atan2(glm::dot(to_eye, axisOf((axis_ + 2) % 3)),
                                  glm::dot(to_eye, axisOf((axis_ + 1) % 3)));
    constexpr double kStep = 0.05;
    const dvec2 a(camera.project(onRing(at, axis_, radius, phi), size));
    const dvec2 b(camera.project(onRing(at, axis_, radius, phi + kStep), size));
    along_ = kStep * (b - a) / std::max(glm::dot(b - a, b - a), 1e-9);
    return;
  }
  last_ = roundAxis(camera, size, mouse);
}

double Turning::roundAxis(const ViewCamera& camera, const dvec2& size, const dvec2& mouse) const {
  const auto hit =
      onPlane(at_, axisOf(axis_), camera.rayOrigin(mouse, size), camera.rayThrough(mouse, size));
  if (!hit) return last_;
  const dvec3 d = *hit - at_;
  return std::atan2(d[(axis_ + 2) % 3], d[(axis_ + 1) % 3]);
}

double Turning::angleDeg(const ViewCamera& camera, const dvec2& size, const dvec2& mouse) {
  if (end_on_) return degrees(glm::dot(mouse - start_, along_));
  const double now = roundAxis(camera, size, mouse);
  angle_ += std::remainder(now - last_, 2.0 * kPi);
  last_ = now;
  return degrees(angle_);
}

}  // namespace soffit::ui
