// SPDX-License-Identifier: MIT
#include "ui/viewport/drawing_polygon.h"

#include "core/light/emitter.h"
#include "ui/viewport/gizmo.h"
#include "ui/viewport/placement.h"
#include "ui/viewport/placing.h"
#include "ui/widgets/quantity.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kGridStep = 0.1;
constexpr double kFineStep = 0.01;
constexpr double kReachPixels = 10.0;
constexpr double kFluxPerArea = 3000.0;  // lm/m^2, about a bright luminous ceiling

double rounded(double v, double step) {
  return std::round(v / step) / std::round(1.0 / step);
}

}  // namespace

std::optional<dvec3> DrawingPolygon::cornerAt(const PointedAt& at, const QPointF& mouse,
                                              Qt::KeyboardModifiers keys) const {
  const ViewCamera& camera = view_.viewCamera();
  const double step = (keys & Qt::ControlModifier) != 0 ? kGridStep : kFineStep;
  if (corners_.empty()) {
    if (!at.surface) return std::nullopt;
    dvec3 p = at.surface->position;
    const Surroundings around = view_.surroundings({});
    if (at.surface->normal.z > -0.5F) p.z = ceilingAbove(around, p).value_or(p.z + 2.5);
    return dvec3(rounded(p.x, step), rounded(p.y, step), p.z - kCeilingGap);
  }
  const dvec2 pixel(mouse.x(), mouse.y());
  const auto hit = onPlane(corners_.front(), axisOf(2), camera.rayOrigin(pixel, view_.viewSize()),
                           camera.rayThrough(pixel, view_.viewSize()));
  if (!hit) return std::nullopt;
  dvec3 p = *hit;
  const double reach =
      kReachPixels * camera.pixelSize(std::max(glm::dot(p - camera.position, camera.forward), 0.1),
                                      view_.viewSize());
  if (corners_.size() > 2 && glm::length(p - corners_.front()) < reach) return corners_.front();
  for (int axis = 0; axis < 2; ++axis) p[axis] = rounded(p[axis], step);
  if ((keys & Qt::AltModifier) == 0) {
    // The lines of the last corner and of the first.
    for (const dvec3& line : {corners_.front(), corners_.back()}) {
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(p[axis] - line[axis]) < reach) p[axis] = line[axis];
      }
    }
  }
  return p;
}

bool DrawingPolygon::closesAt(const dvec3& corner) const {
  return corners_.size() > 2 && corner == corners_.front();
}

void DrawingPolygon::show(const std::optional<dvec3>& next) {
  ViewOverlay::Content content;
  std::vector<dvec3> chain = corners_;
  if (next) chain.push_back(*next);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    content.lines.push_back(
        {chain[i], chain[i + 1], ViewOverlay::Stroke::outline,
         formatQuantity(glm::length(chain[i + 1] - chain[i]), Dimension::length, 2)});
  }
  if (chain.size() > 2 && next && !closesAt(*next)) {
    content.lines.push_back({chain.back(), chain.front(), ViewOverlay::Stroke::guide, {}});
  }
  if (chain.size() == 1) content.labels.push_back({chain.front(), tr("first corner")});
  Q_EMIT contentChanged(content);
}

void DrawingPolygon::hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) {
  show(cornerAt(at, mouse, keys));
}

void DrawingPolygon::click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) {
  const auto corner = cornerAt(at, mouse, keys);
  if (!corner) return;
  if (closesAt(*corner)) {
    close();
    return;
  }
  if (!corners_.empty() && glm::length(*corner - corners_.back()) < 1e-6) return;
  corners_.push_back(*corner);
  show(std::nullopt);
  Q_EMIT hintChanged(hint());
}

bool DrawingPolygon::key(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      close();
      return true;
    case Qt::Key_Backspace:
      if (!corners_.empty()) corners_.pop_back();
      show(std::nullopt);
      return true;
    default:
      return false;
  }
}

void DrawingPolygon::close() {
  if (corners_.size() < 3) return;
  dvec3 lo = corners_.front();
  dvec3 hi = lo;
  for (const dvec3& c : corners_) {
    lo = glm::min(lo, c);
    hi = glm::max(hi, c);
  }
  LuminaireType type;
  type.name = tr("Polygon");
  light::Luminaire& luminaire = type.prototype;
  luminaire.position = 0.5 * (lo + hi);
  light::Polygon polygon;
  double twice_area = 0.0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const dvec2 p = dvec2(corners_[i] - luminaire.position);
    const dvec2 q = dvec2(corners_[(i + 1) % corners_.size()] - luminaire.position);
    polygon.outline.push_back(p);
    twice_area += p.x * q.y - p.y * q.x;
  }
  luminaire.shape = polygon;
  luminaire.flux = std::max(10.0, 10.0 * std::round(0.05 * kFluxPerArea * std::abs(twice_area)));
  luminaire.colour.cct_k = 4000.0;
  luminaire.group = tr("General").toStdString();
  if (const auto made = light::makeEmitter(luminaire); !made) {
    Q_EMIT hintChanged(tr("The outline crosses itself: take corners back with Backspace."));
    return;
  }
  addLuminaire(document_, type, luminaire);
  Q_EMIT finished();
}

QString DrawingPolygon::hint() const {
  if (corners_.size() < 3) {
    return tr("Click the corners of the luminaire on the ceiling. Ctrl: grid. Esc: give up.");
  }
  return tr("Next corner; Enter or the first corner closes the outline. Backspace: take one back.");
}

}  // namespace soffit::ui
