// SPDX-License-Identifier: MIT
#include "ui/widgets/profile_chart.h"

#include "core/color/false_color.h"
#include "ui/widgets/quantity.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kMargin = 10;
const QColor kPlate(20, 22, 26, 220);
const QColor kInk(238, 240, 244);
const QColor kGrid(238, 240, 244, 50);
const QColor kCurve(255, 184, 40);

}  // namespace

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent), close_(new QToolButton(this)) {
  setAccessibleName(tr("Illuminance along a line"));
  close_->setText(QStringLiteral("\u00d7"));
  close_->setToolTip(tr("Close the profile"));
  close_->setAutoRaise(true);
  close_->setStyleSheet(QStringLiteral("color: #eef0f4;"));
  connect(close_, &QToolButton::clicked, this, &ProfileChart::closeRequested);
}

void ProfileChart::setPoints(std::vector<Point> points) {
  points_ = std::move(points);
  update();
}

void ProfileChart::resizeEvent(QResizeEvent*) {
  close_->adjustSize();
  close_->move(width() - close_->width() - 4, 4);
}

void ProfileChart::mousePressEvent(QMouseEvent* event) {
  event->accept();  // not a click into the view beneath
}

QString ProfileChart::summary() const {
  double sum = 0.0;
  double least = 1e30;
  double most = 0.0;
  int count = 0;
  for (const Point& p : points_) {
    if (p.lux < 0.0) continue;
    sum += p.lux;
    least = std::min(least, p.lux);
    most = std::max(most, p.lux);
    ++count;
  }
  if (count == 0) return tr("No lit surface along the line");
  const auto shown = [](double lux) { return formatReading(lux, Dimension::illuminance); };
  return tr("\u0112m %1   Emin %2   Emax %3 %4")
      .arg(shown(sum / count), shown(least), shown(most), unitOf(Dimension::illuminance));
}

void ProfileChart::paintAxes(QPainter& painter, const QRectF& plot, double most) const {
  const double lux = shownUnit(Dimension::illuminance);
  const double metre = shownUnit(Dimension::length);
  const double line = fontMetrics().height();
  for (const auto& tick : color::legendTicks({0.0, most / lux}, 5)) {
    const double y = plot.bottom() - static_cast<double>(tick.place) * plot.height();
    painter.setPen(kGrid);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(kInk);
    painter.drawText(QRectF(0.0, y - 0.5 * line, plot.left() - 5.0, line),
                     Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(tick.label));
  }
  for (const auto& tick : color::legendTicks({0.0, points_.back().way / metre}, 7)) {
    const double x = plot.left() + static_cast<double>(tick.place) * plot.width();
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 3.0));
    QString text = QString::fromStdString(tick.label);
    if (tick.lux == 0.0) text += QLatin1Char(' ') + unitOf(Dimension::length);
    painter.drawText(QRectF(x - 30.0, plot.bottom() + 3.0, 60.0, line), Qt::AlignCenter, text);
  }
}

void ProfileChart::paintCurve(QPainter& painter, const QRectF& plot, double most) const {
  QPainterPath path;
  bool drawing = false;
  for (const Point& p : points_) {
    const QPointF at(plot.left() + p.way / points_.back().way * plot.width(),
                     plot.bottom() - std::min(p.lux / most, 1.0) * plot.height());
    if (p.lux < 0.0) {
      drawing = false;
    } else if (std::exchange(drawing, true)) {
      path.lineTo(at);
    } else {
      path.moveTo(at);
    }
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kCurve, 1.8));
  painter.drawPath(path);
}

void ProfileChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kPlate);
  painter.drawRoundedRect(rect(), 6, 6);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(kInk);
  const int line = fontMetrics().height();
  painter.drawText(QPointF(kMargin, kMargin + fontMetrics().ascent()), summary());
  if (points_.size() < 2 || points_.back().way <= 0.0) return;
  double most = 1e-6;
  for (const Point& p : points_) most = std::max(most, p.lux);
  most = color::roundRange(most).max;
  const double left = fontMetrics().horizontalAdvance(QStringLiteral("00000")) + kMargin;
  const QRectF plot(QPointF(left, 2.0 * kMargin + line),
                    QPointF(width() - 2.0 * kMargin, height() - line - kMargin));
  paintAxes(painter, plot, most);
  paintCurve(painter, plot, most);
}

}  // namespace soffit::ui
