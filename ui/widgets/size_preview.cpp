// SPDX-License-Identifier: MIT
#include "ui/widgets/size_preview.h"

#include "ui/widgets/quantity.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kPerson = 1.75;      // m
constexpr double kDepthShare = 0.35;  ///< of a length in the picture's depth, drawn at 45 degrees

QString metres(double length) {
  const int decimals = length < 0.1 ? 4 : length < 100.0 ? 2 : 0;
  return formatNumber(length, decimals) + QStringLiteral("\u00a0m");
}

/// A person standing at (0, 0), one unit tall, y up.
QPainterPath person() {
  QPainterPath path;
  path.addEllipse(QPointF(0.0, 0.925), 0.065, 0.075);
  path.addRoundedRect(QRectF(-0.13, 0.46, 0.26, 0.38), 0.08, 0.08);
  path.addRoundedRect(QRectF(-0.1, 0.0, 0.085, 0.5), 0.03, 0.03);
  path.addRoundedRect(QRectF(0.015, 0.0, 0.085, 0.5), 0.03, 0.03);
  path.setFillRule(Qt::WindingFill);
  return path;
}

}  // namespace

SizePreview::SizePreview(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 160);
}

void SizePreview::setSize(const std::optional<dvec3>& size, const QString& text) {
  size_ = size;
  text_ = text;
  setAccessibleName(
      size ? tr("%1 wide, %2 deep, %3 high").arg(metres(size->x), metres(size->y), metres(size->z))
           : text);
  update();
}

void SizePreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  const QRectF room = QRectF(rect()).adjusted(14, 14, -14, -14);
  if (!size_) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, text_);
    return;
  }
  const double line = fontMetrics().height();
  const double depth = kDepthShare * size_->y;
  const double tall = std::max(size_->z + depth, kPerson);
  const double wide = size_->x + depth + kPerson;  // the person needs less than its height
  const double side = fontMetrics().horizontalAdvance(QStringLiteral("0000.00 m")) + 10;
  const double scale = std::min((room.height() - 1.6 * line) / tall, (room.width() - side) / wide);
  const double floor = room.bottom() - 1.4 * line;
  const double left = room.left() + 0.8 * kPerson * scale;
  const QRectF front(left, floor - size_->z * scale, size_->x * scale, size_->z * scale);
  const QPointF back(depth * scale, -depth * scale);

  QColor fill = palette().color(QPalette::Highlight);
  painter.setPen(QPen(fill, 1.5));
  fill.setAlpha(46);
  painter.setBrush(fill);
  painter.drawPolygon(QPolygonF{front.topLeft(), front.topRight(), front.topRight() + back,
                                front.topLeft() + back});
  painter.drawPolygon(QPolygonF{front.topRight(), front.bottomRight(), front.bottomRight() + back,
                                front.topRight() + back});
  painter.drawRect(front);

  painter.save();
  painter.translate(room.left() + 0.4 * kPerson * scale, floor);
  painter.scale(kPerson * scale, -kPerson * scale);
  painter.fillPath(person(), palette().color(QPalette::PlaceholderText));
  painter.restore();

  painter.setPen(palette().color(QPalette::Text));
  const QRectF below(front.left(), floor + 0.2 * line, std::max(front.width(), side), 1.2 * line);
  painter.drawText(below, front.width() > side ? Qt::AlignHCenter : Qt::AlignLeft,
                   metres(size_->x));
  painter.drawText(front.bottomRight() + 0.5 * back + QPointF(6, 0.5 * line), metres(size_->y));
  painter.drawText(front.topRight() + back + QPointF(6, 0.5 * front.height()), metres(size_->z));
}

}  // namespace soffit::ui
