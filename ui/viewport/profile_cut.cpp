// SPDX-License-Identifier: MIT
#include "ui/viewport/profile_cut.h"

#include "ui/widgets/quantity.h"

#include <cmath>

namespace soffit::ui {
namespace {

constexpr int kSteps = 240;
constexpr double kShortest = 0.02;  // m

}  // namespace

std::vector<ProfileChart::Point> profileOf(const ProfileCut& cut, const LightFrame& frame,
                                           const scene::Scene& scene) {
  std::vector<ProfileChart::Point> points;
  const double length = glm::length(cut.to - cut.from);
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const auto light = readProbe(frame, scene, {"", glm::mix(cut.from, cut.to, share), cut.normal});
    points.push_back({share * length, light ? light->lux : -1.0});
  }
  return points;
}

std::optional<ProfileCut> DrawingProfile::cutTo(const QPointF& mouse) const {
  const ViewCamera& camera = view_.viewCamera();
  const dvec2 pixel(mouse.x(), mouse.y());
  const dvec3 eye = camera.rayOrigin(pixel, view_.viewSize());
  const dvec3 way = camera.rayThrough(pixel, view_.viewSize());
  const double facing = glm::dot(way, start_->normal);
  const double t = glm::dot(start_->from - eye, start_->normal) / facing;
  if (!(t > 0.0) || !std::isfinite(t)) return std::nullopt;
  ProfileCut cut = *start_;
  cut.to = eye + t * way;
  if (glm::length(cut.to - cut.from) < kShortest) return std::nullopt;
  return cut;
}

void DrawingProfile::hover(const PointedAt&, const QPointF& mouse, Qt::KeyboardModifiers) {
  if (!start_) return;
  ViewOverlay::Content content;
  if (const auto cut = cutTo(mouse)) {
    content.lines.push_back(
        {cut->from, cut->to, ViewOverlay::Stroke::measure,
         formatQuantity(glm::length(cut->to - cut->from), Dimension::length, 2)});
    Q_EMIT cutChanged(*cut);
  }
  Q_EMIT contentChanged(content);
}

void DrawingProfile::click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers) {
  if (!start_) {
    if (!at.surface) return;
    start_ = ProfileCut{at.surface->position, at.surface->position, dvec3(at.surface->normal)};
    Q_EMIT hintChanged(hint());
    return;
  }
  const auto cut = cutTo(mouse);
  if (!cut) return;
  Q_EMIT cutChanged(*cut);
  Q_EMIT finished();
}

QString DrawingProfile::hint() const {
  return start_ ? tr("Click the end of the line. Esc: done.")
                : tr("Click the start of the line on a surface. Esc: done.");
}

}  // namespace soffit::ui
