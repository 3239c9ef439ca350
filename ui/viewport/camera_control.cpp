// SPDX-License-Identifier: MIT
#include "ui/viewport/camera_control.h"

#include <QGuiApplication>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kRadiansPerPixel = 0.006;
constexpr double kLookPerPixel = 0.003;
constexpr double kStepsPerNotch = 0.85;
constexpr double kDefaultDepth = 3.0;
constexpr double kCutPerNotch = 0.1;  // m
constexpr int kStepMs = 12;
constexpr int kWheelRestMs = 150;
/// A camera that has not moved for so long is a place to come back to.
constexpr int kSettleMs = 350;

}  // namespace

CameraControl::CameraControl(SceneView& view) : view_(view) {
  steps_.setTimerType(Qt::PreciseTimer);
  steps_.setInterval(kStepMs);
  connect(&steps_, &QTimer::timeout, this, &CameraControl::step);
  wheel_rest_.setSingleShot(true);
  wheel_rest_.setInterval(kWheelRestMs);
  connect(&wheel_rest_, &QTimer::timeout, this, [this] {
    // Something is dragged already: its end is the end of moving, too.
    if (QGuiApplication::mouseButtons() == Qt::NoButton) setMoving();
  });
  settling_.setSingleShot(true);
  settling_.setInterval(kSettleMs);
  connect(&settling_, &QTimer::timeout, this, [this] {
    if (way_ != Way::none) {
      settling_.start();
    } else {
      history_.settle(view_.viewCamera());
    }
  });
  connect(&view_, &SceneView::cameraMoved, this, &CameraControl::onMoved);
}

void CameraControl::onMoved() {
  settling_.start();
}

void CameraControl::setMoving() {
  view_.setMoving(way_ != Way::none || wheel_rest_.isActive());
}

void CameraControl::begin(Way way, const PointedAt& from) {
  const ViewCamera& camera = view_.viewCamera();
  // What was looked at before is a place to come back to, however soon.
  history_.settle(camera);
  pivot_ = from.hit ? from.place : camera.position + kDefaultDepth * camera.forward;
  way_ = camera.isParallel() ? Way::pan : way;
  setMoving();
}

void CameraControl::moveBy(const QPointF& delta) {
  ViewCamera camera = view_.viewCamera();
  switch (way_) {
    case Way::none:
      return;
    case Way::orbit:
      camera.orbit(pivot_, -delta.x() * kRadiansPerPixel, -delta.y() * kRadiansPerPixel);
      break;
    case Way::look:
      camera.look(-delta.x() * kLookPerPixel, -delta.y() * kLookPerPixel);
      break;
    case Way::pan:
      camera.pan({delta.x(), delta.y()}, glm::dot(pivot_ - camera.position, camera.forward),
                 view_.viewSize());
      break;
  }
  view_.setViewCamera(camera);
}

void CameraControl::end() {
  if (steps_.isActive()) {
    steps_.stop();
    stood_ = view_.viewCamera().position;
    Q_EMIT hintChanged({});
  }
  keys_.clear();
  walking_.stop();
  way_ = Way::none;
  setMoving();
}

void CameraControl::wheel(double notches, const PointedAt& at, const QPointF& mouse, bool cut) {
  if (way_ == Way::look) {
    walking_.changeSpeed(notches);
    showHint();
    return;
  }
  ViewCamera camera = view_.viewCamera();
  if (cut && camera.isParallel()) {
    const double place = camera.cutPlace() + kCutPerNotch * notches;
    camera.setCutPlace(kCutPerNotch * std::round(place / kCutPerNotch));
  } else {
    const dvec2 pixel(mouse.x(), mouse.y());
    const dvec3 target = at.hit ? at.place
                                : camera.rayOrigin(pixel, view_.viewSize()) +
                                      kDefaultDepth * camera.rayThrough(pixel, view_.viewSize());
    camera.approach(target, std::pow(kStepsPerNotch, notches));
  }
  wheel_rest_.start();
  setMoving();
  view_.setViewCamera(camera);
}

bool CameraControl::wantsKey(const QKeyEvent& event) const {
  if (way_ != Way::look) return false;
  switch (event.key()) {
    case Qt::Key_W:
    case Qt::Key_A:
    case Qt::Key_S:
    case Qt::Key_D:
    case Qt::Key_Q:
    case Qt::Key_E:
    case Qt::Key_Shift:
      return true;
    default:
      return false;
  }
}

void CameraControl::key(const QKeyEvent& event, bool pressed) {
  if (event.isAutoRepeat()) return;
  if (pressed) {
    keys_.insert(event.key());
  } else {
    keys_.erase(event.key());
  }
  if (steps_.isActive() || wish().none()) return;
  if (glm::length(view_.viewCamera().position - stood_) > 1e-6) walking_.standUp();
  clock_.start();
  steps_.start();
  showHint();
}

Walking::Wish CameraControl::wish() const {
  const auto one = [&](Qt::Key less, Qt::Key more) {
    return double{1.0} * static_cast<int>(keys_.contains(more)) -
           static_cast<int>(keys_.contains(less));
  };
  return {{one(Qt::Key_A, Qt::Key_D), one(Qt::Key_S, Qt::Key_W), one(Qt::Key_Q, Qt::Key_E)},
          keys_.contains(Qt::Key_Shift)};
}

void CameraControl::step() {
  const double seconds = 1e-3 * static_cast<double>(clock_.restart());
  ViewCamera camera = view_.viewCamera();
  walking_.advance(camera, wish(), seconds, [this](const dvec3& from, const dvec3& direction) {
    std::optional<Walking::Met> met;
    if (const auto surface = view_.surfaceAlong(from, direction)) {
      met = {glm::length(surface->position - from), dvec3(surface->normal)};
    }
    return met;
  });
  if (camera == view_.viewCamera()) return;
  view_.setViewCamera(camera);
}

void CameraControl::showHint() {
  Q_EMIT hintChanged(tr("Walking at %L1 m/s: W A S D, Q down, E up, Shift faster, wheel: speed")
                         .arg(walking_.speed(), 0, 'f', 1));
}

void CameraControl::back() {
  settling_.stop();
  if (const auto camera = history_.back(view_.viewCamera())) view_.setViewCamera(*camera);
}

void CameraControl::forward() {
  settling_.stop();
  if (const auto camera = history_.forward(view_.viewCamera())) view_.setViewCamera(*camera);
}

}  // namespace soffit::ui
