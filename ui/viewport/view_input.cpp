// SPDX-License-Identifier: MIT
#include "ui/viewport/view_input.h"

#include "ui/document/text.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kRadiansPerPixel = 0.006;
constexpr double kLookPerPixel = 0.003;
constexpr double kStepsPerNotch = 0.85;
constexpr double kGridStep = 0.1;   // m
constexpr double kFineStep = 1e-3;  // m: dragged places are whole millimetres
constexpr double kDefaultDepth = 3.0;

dvec2 pixel(const QPointF& p) {
  return {p.x(), p.y()};
}

double rounded(double v, double step) {
  return std::round(v / step) * step;
}

}  // namespace

ViewInput::ViewInput(SceneView& view, QObject* parent) : QObject(parent), view_(view) {
  view_.installEventFilter(this);
  wheel_rest_.setSingleShot(true);
  wheel_rest_.setInterval(150);
  connect(&wheel_rest_, &QTimer::timeout, this, [this] {
    if (mode_ == Mode::none) view_.setMoving(false);
  });
}

bool ViewInput::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
      if (!view_.pointAt(static_cast<const QMouseEvent&>(*event).position()).luminaire.empty()) {
        Q_EMIT editRequested();
      }
      return true;
    case QEvent::Wheel:
      return wheel(static_cast<const QWheelEvent&>(*event));
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    case QEvent::Leave:
      view_.setHovered({});
      view_.setGizmoHighlight(GizmoPart::none);
      Q_EMIT left();
      return false;
    default:
      return false;
  }
}

bool ViewInput::press(const QMouseEvent& event) {
  if (mode_ != Mode::none || document_ == nullptr) return true;
  start_ = last_ = event.position();
  pressed_ = view_.pointAt(start_);
  const ViewCamera& camera = view_.viewCamera();
  pivot_ = pressed_.hit ? pressed_.place : camera.position + kDefaultDepth * camera.forward;
  const bool left = event.button() == Qt::LeftButton;
  if (event.button() == Qt::MiddleButton || (left && (event.modifiers() & Qt::ShiftModifier))) {
    mode_ = Mode::pan;
    view_.setMoving(true);
  } else if (event.button() == Qt::RightButton) {
    mode_ = Mode::look;
    view_.setMoving(true);
  } else if (left) {
    pressed_part_ = view_.gizmoPartAt(start_);
    mode_ = Mode::pressed;
  }
  return true;
}

void ViewInput::select(const std::string& name, bool add) {
  QStringList names = add ? document_->selection() : QStringList();
  const QString luminaire = toQt(name);
  if (!name.empty()) {
    if (add && names.contains(luminaire)) {
      names.removeAll(luminaire);
    } else {
      names.append(luminaire);
    }
  }
  document_->setSelection(names);
}

/// The press became a drag.
void ViewInput::beginPressed(const QMouseEvent& event) {
  const bool body = pressed_part_ == GizmoPart::none && !pressed_.luminaire.empty();
  if (body && !document_->selection().contains(toQt(pressed_.luminaire))) {
    select(pressed_.luminaire, (event.modifiers() & Qt::ControlModifier) != 0);
  }
  view_.setMoving(true);
  const auto at = view_.gizmoPlace();
  if ((!body && pressed_part_ == GizmoPart::none) || !at) {
    mode_ = Mode::orbit;
    return;
  }
  mode_ = Mode::drag;
  gizmo_start_ = *at;
  gizmo_.emplace(body ? GizmoPart::free : pressed_part_, *at, view_.viewCamera(), view_.viewSize(),
                 pixel(start_));
  view_.setGizmoHighlight(gizmo_->part());
}

void ViewInput::dragTo(const QPointF& mouse, bool stepped) {
  dvec3 offset = gizmo_->moved(view_.viewCamera(), view_.viewSize(), pixel(mouse)) - gizmo_start_;
  const double step = stepped ? kGridStep : kFineStep;
  for (int i = 0; i < 3; ++i) offset[i] = rounded(offset[i], step);
  document_->preview(document_->selection(), [&](light::Luminaire& l) {
    for (int i = 0; i < 3; ++i) {
      if (offset[i] != 0.0) l.position[i] = rounded(l.position[i] + offset[i], kFineStep);
    }
  });
}

void ViewInput::hover(const QPointF& mouse) {
  const GizmoPart part = view_.gizmoPartAt(mouse);
  const PointedAt at = view_.pointAt(mouse);
  view_.setGizmoHighlight(part);
  view_.setHovered(part == GizmoPart::none ? at.luminaire : std::string());
  const bool hand = part != GizmoPart::none || !at.luminaire.empty();
  view_.setCursor(hand ? Qt::PointingHandCursor : Qt::ArrowCursor);
  Q_EMIT pointed(at);
}

bool ViewInput::move(const QMouseEvent& event) {
  const QPointF now = event.position();
  const QPointF delta = now - last_;
  if (mode_ == Mode::none) {
    hover(now);
    return true;
  }
  if (mode_ == Mode::pressed) {
    if ((now - start_).manhattanLength() < QApplication::startDragDistance()) return true;
    beginPressed(event);
  }
  last_ = now;
  ViewCamera camera = view_.viewCamera();
  switch (mode_) {
    case Mode::drag:
      dragTo(now, (event.modifiers() & Qt::ControlModifier) != 0);
      return true;
    case Mode::orbit:
      camera.orbit(pivot_, -delta.x() * kRadiansPerPixel, -delta.y() * kRadiansPerPixel);
      break;
    case Mode::look:
      camera.look(-delta.x() * kLookPerPixel, -delta.y() * kLookPerPixel);
      break;
    case Mode::pan:
      camera.pan(pixel(delta), glm::dot(pivot_ - camera.position, camera.forward),
                 view_.viewSize());
      break;
    default:
      return true;
  }
  view_.setViewCamera(camera);
  return true;
}

void ViewInput::endMode() {
  mode_ = Mode::none;
  gizmo_.reset();
  view_.setMoving(false);
}

bool ViewInput::release(const QMouseEvent& event) {
  if (event.buttons() != Qt::NoButton) return true;
  const Mode ended = mode_;
  endMode();
  if (document_ == nullptr) return true;
  if (ended == Mode::pressed && pressed_part_ == GizmoPart::none) {
    select(pressed_.luminaire, (event.modifiers() & Qt::ControlModifier) != 0);
  } else if (ended == Mode::drag) {
    const QStringList names = document_->selection();
    document_->commitPreview(
        names.size() == 1 ? tr("Move %1").arg(names.front())
                          : tr("Move %n luminaires", nullptr, static_cast<int>(names.size())));
  }
  hover(event.position());
  return true;
}

bool ViewInput::wheel(const QWheelEvent& event) {
  if (document_ == nullptr) return true;
  const PointedAt at = view_.pointAt(event.position());
  ViewCamera camera = view_.viewCamera();
  const dvec3 target =
      at.hit ? at.place
             : camera.position +
                   kDefaultDepth * camera.rayThrough(pixel(event.position()), view_.viewSize());
  const double notches = event.angleDelta().y() / 120.0;
  view_.setMoving(true);
  wheel_rest_.start();
  camera.approach(target, std::pow(kStepsPerNotch, notches));
  view_.setViewCamera(camera);
  return true;
}

bool ViewInput::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || document_ == nullptr) return false;
  if (mode_ == Mode::drag) {
    endMode();
    document_->cancelPreview();
  } else {
    document_->setSelection({});
  }
  return true;
}

}  // namespace soffit::ui
