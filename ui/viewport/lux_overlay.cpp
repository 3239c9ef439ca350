// SPDX-License-Identifier: MIT
#include "ui/viewport/lux_overlay.h"

#include "ui/viewport/scene_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

/// After the last movement, before lines get their values.
constexpr int kRestMs = 220;

}  // namespace

LuxOverlay::LuxOverlay(SceneView& view) : QWidget(&view), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  QFont numbers = font();
  numbers.setPointSizeF(0.92 * numbers.pointSizeF());
  setFont(numbers);
  view_.installEventFilter(this);
  setGeometry(view_.rect());
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &LuxOverlay::labelLines);
  connect(&view_, &SceneView::cameraMoved, this, &LuxOverlay::refresh);
  connect(&view_, &SceneView::lightShown, this, &LuxOverlay::refresh);
  hide();
}

bool LuxOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    setGeometry(view_.rect());
    refresh();
  }
  return QWidget::eventFilter(watched, event);
}

void LuxOverlay::setMarks(LuxMarks marks) {
  marks_ = std::move(marks);
  refresh();
}

/// Hidden when there is nothing to say: the view is not composed with it then.
void LuxOverlay::refresh() {
  stale_ = true;
  labels_.clear();
  const bool lines = !view_.look().levels.empty();
  if (lines) rest_.start();
  setVisible(lines || !marks_.empty());
  update();
}

void LuxOverlay::labelLines() {
  if (view_.isMoving()) {
    rest_.start();
    return;
  }
  const render::LuxPicture picture = view_.readLux();
  if (picture.lux.empty() || view_.look().levels.empty()) return;
  label_scale_ = static_cast<double>(width()) / picture.width;
  labels_ = render::placeLineLabels(picture, view_.look().levels, labelRoom(font(), label_scale_));
  stale_ = true;
  update();
}

Sight LuxOverlay::sight(const ViewCamera& camera, const dvec2& size) const {
  return {camera, size, [this, camera](const dvec3& place) { return view_.isSeen(camera, place); }};
}

const SeenMarks& LuxOverlay::seen() {
  if (std::exchange(stale_, false)) {
    seen_ = seenFrom(marks_, sight(view_.viewCamera(), view_.viewSize()), font());
    addLineLabels(labels_, label_scale_, view_.look().scale, font(), seen_);
  }
  return seen_;
}

void LuxOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, seen());
}

}  // namespace soffit::ui
