// SPDX-License-Identifier: MIT
#include "ui/viewport/probe_drag.h"

#include "ui/viewport/scene_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kReach = 8.0;  // logical pixels

}  // namespace

ProbeDrag::ProbeDrag(SceneView& view, QObject* parent) : QObject(parent), view_(view) {
  view_.installEventFilter(this);
}

std::optional<std::size_t> ProbeDrag::pinAt(const QPointF& mouse) const {
  const ViewCamera& camera = view_.viewCamera();
  // The last one lies on top.
  for (std::size_t i = pins_.size(); i-- > 0;) {
    const dvec3 at = camera.project(pins_[i], view_.viewSize());
    if (at.z <= 0.0 || std::hypot(at.x - mouse.x(), at.y - mouse.y()) > kReach) continue;
    if (view_.isSeen(camera, pins_[i])) return i;
  }
  return std::nullopt;
}

bool ProbeDrag::move(const QPointF& mouse) {
  if (!moving_ && (mouse - start_).manhattanLength() < QApplication::startDragDistance()) {
    return true;
  }
  moving_ = true;
  const PointedAt at = view_.pointAt(mouse);
  if (at.surface) Q_EMIT moved(*held_, *at.surface);
  return true;
}

bool ProbeDrag::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      if (held_) return true;
      if (mouse.button() != Qt::LeftButton || mouse.modifiers() != Qt::NoModifier) break;
      held_ = pinAt(mouse.position());
      if (!held_) break;
      start_ = mouse.position();
      moving_ = false;
      Q_EMIT chosen(*held_);
      return true;
    }
    case QEvent::MouseMove:
      if (held_) return move(static_cast<QMouseEvent*>(event)->position());
      break;
    case QEvent::MouseButtonRelease:
      if (!held_) break;
      held_.reset();
      if (moving_) Q_EMIT finished();
      return true;
    case QEvent::KeyPress:
      if (!held_ || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) break;
      held_.reset();
      if (moving_) Q_EMIT canceled();
      return true;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace soffit::ui
