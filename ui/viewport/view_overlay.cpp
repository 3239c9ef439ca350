// SPDX-License-Identifier: MIT
#include "ui/viewport/view_overlay.h"

#include "ui/viewport/scene_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

const QColor kGuide(255, 196, 64);
const QColor kMeasure(240, 242, 246);
const QColor kOutline(255, 184, 40);
const QColor kPlate(20, 22, 26, 205);
const QColor kShade(0, 0, 0, 150);
constexpr double kNearest = 0.05;   // m before the eye
constexpr double kHandle = 5.5;     // pixels, half its size
constexpr double kTick = 4.0;       // pixels
constexpr double kShortest = 22.0;  // pixels; a shorter line has no room for its length
constexpr QPointF kLabelOffset(16.0, -34.0);

}  // namespace

ViewOverlay::ViewOverlay(SceneView& view) : QWidget(&view), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  view_.installEventFilter(this);
  setGeometry(view_.rect());
  hide();
}

bool ViewOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) setGeometry(view_.rect());
  return QWidget::eventFilter(watched, event);
}

void ViewOverlay::setContent(Content content) {
  content_ = std::move(content);
  refresh();
}

void ViewOverlay::setBand(const std::optional<QRectF>& band) {
  band_ = band;
  refresh();
}

/// Hidden when there is nothing to say: the view is not composed with it then.
void ViewOverlay::refresh() {
  setVisible(band_.has_value() || !content_.handles.empty() || !content_.lines.empty() ||
             !content_.labels.empty());
  update();
}

std::optional<QPointF> ViewOverlay::pixelOf(const dvec3& place) const {
  const dvec3 at = view_.viewCamera().project(place, view_.viewSize());
  if (at.z < kNearest) return std::nullopt;
  return QPointF(at.x, at.y);
}

void ViewOverlay::paintText(QPainter& painter, const QPointF& at, const QString& text,
                            bool centered) const {
  const QFontMetricsF metrics(painter.font());
  QRectF plate(0.0, 0.0, metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0);
  plate.moveTopLeft(at);
  if (centered) plate.moveCenter(at);
  // Words stay in the picture.
  plate.moveLeft(std::clamp(plate.left(), 2.0, std::max(2.0, width() - plate.width() - 2.0)));
  plate.moveTop(std::clamp(plate.top(), 2.0, std::max(2.0, height() - plate.height() - 2.0)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kPlate);
  painter.drawRoundedRect(plate, 4.0, 4.0);
  painter.setPen(kMeasure);
  painter.drawText(plate, Qt::AlignCenter, text);
}

void ViewOverlay::paintLine(QPainter& painter, const Line& line) const {
  const auto from = pixelOf(line.from);
  const auto to = pixelOf(line.to);
  if (!from || !to) return;
  const QPointF way = *to - *from;
  const double length = std::hypot(way.x(), way.y());
  if (length < 1.0) return;
  QPen pen(line.stroke == Stroke::guide     ? kGuide
           : line.stroke == Stroke::measure ? kMeasure
                                            : kOutline,
           line.stroke == Stroke::outline ? 2.0 : 1.2);
  if (line.stroke == Stroke::guide) pen.setDashPattern({5.0, 4.0});
  QPen shade(kShade, pen.widthF() + 2.0);
  const QPointF across = kTick / length * QPointF(-way.y(), way.x());
  for (const QPen& stroke : {shade, pen}) {
    painter.setPen(stroke);
    painter.drawLine(*from, *to);
    if (line.stroke != Stroke::measure) continue;
    painter.drawLine(*from - across, *from + across);
    painter.drawLine(*to - across, *to + across);
  }
  if (!line.text.isEmpty() && length > kShortest) {
    paintText(painter, 0.5 * (*from + *to), line.text, true);
  }
}

void ViewOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Line& line : content_.lines) paintLine(painter, line);
  for (const Handle& handle : content_.handles) {
    const auto at = pixelOf(handle.at);
    if (!at) continue;
    const QRectF box(at->x() - kHandle, at->y() - kHandle, 2.0 * kHandle, 2.0 * kHandle);
    painter.setPen(QPen(kShade, 1.5));
    painter.setBrush(handle.lit ? kGuide : kMeasure);
    if (handle.round) {
      painter.drawEllipse(box);
    } else {
      painter.drawRect(box);
    }
  }
  for (const Label& label : content_.labels) {
    if (const auto at = pixelOf(label.at))
      paintText(painter, *at + kLabelOffset, label.text, false);
  }
  if (!band_) return;
  painter.setPen(QPen(kShade, 3.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(*band_);
  painter.setPen(QPen(kGuide, 1.2));
  painter.setBrush(QColor(kGuide.red(), kGuide.green(), kGuide.blue(), 40));
  painter.drawRect(*band_);
}

}  // namespace soffit::ui
