// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo_scaling.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kReachPixels = 9.0;
constexpr double kDoublePixels = 100.0;
constexpr double kLeastFactor = 0.01;
/// A handle nearer to the middle than this on the screen is seen end on.
constexpr double kShortestPixels = 14.0;

}  // namespace

GizmoPart Scaling::partAt(const dvec3& at, const dmat3& frame, const ViewCamera& camera,
                          const dvec2& size, const dvec2& mouse) {
  if (glm::dot(at - camera.position, camera.forward) <= 0.0) return GizmoPart::none;
  const double length = Gizmo::arrowLength(at, camera, size);
  const dvec2 middle(camera.project(at, size));
  if (glm::length(mouse - middle) < 1.3 * kMiddle * Gizmo::kArrowPixels) return GizmoPart::free;
  GizmoPart best = GizmoPart::none;
  double nearest = kReachPixels;
  for (const GizmoPart part : {GizmoPart::x, GizmoPart::y, GizmoPart::z}) {
    const dvec2 tip(camera.project(at + length * frame[axisIndexOf(part)], size));
    if (glm::length(tip - middle) < kShortestPixels) continue;
    const double d = distanceToSegment(mouse, middle, middle + 1.08 * (tip - middle));
    if (d < nearest) {
      nearest = d;
      best = part;
    }
  }
  return best;
}

Scaling::Scaling(GizmoPart part, const dvec3& at, const dmat3& frame, const ViewCamera& camera,
                 const dvec2& size, const dvec2& mouse)
    : part_(part), start_(mouse), middle_(camera.project(at, size)) {
  if (!isAxis(part)) return;
  const double length = Gizmo::arrowLength(at, camera, size);
  const dvec2 tip(camera.project(at + length * frame[axisIndexOf(part)], size));
  const double pixels = glm::length(tip - middle_);
  if (pixels > 1e-9) along_ = (tip - middle_) / pixels;
}

double Scaling::factor(const dvec2& mouse) const {
  if (!isAxis(part_)) {
    const dvec2 way = mouse - start_;
    return std::max(std::exp2((way.x - way.y) / kDoublePixels), kLeastFactor);
  }
  const double before = std::max(glm::dot(start_ - middle_, along_), kShortestPixels);
  return std::max((before + glm::dot(mouse - start_, along_)) / before, kLeastFactor);
}

}  // namespace soffit::ui
