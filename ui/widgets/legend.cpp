// SPDX-License-Identifier: MIT
#include "ui/widgets/legend.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kMargin = 12;
constexpr int kBarWidth = 16;
constexpr double kMark = 5.0;  // pixels, half the height of the reading's mark
const QColor kPlate(20, 22, 26, 235);
const QColor kInk(238, 240, 244);

QColor toQt(const vec3& c) {
  return QColor::fromRgbF(c.x, c.y, c.z);
}

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(tr("Scale of illuminance"));
  setToolTip(tr("Scale of illuminance; a click: its range, steps and colours"));
  setScale(color::LuxScale{});
}

void Legend::setScale(const color::LuxScale& scale, std::vector<double> levels) {
  setScale([scale](float place) { return scale.colorAt(place); },
           [scale](int most) { return color::legendTicks(scale, most); });
  scale_ = scale;
  levels_ = std::move(levels);
  differences_ = false;
}

void Legend::setScale(Colors colors, Ticks ticks, const QString& unit) {
  colors_ = std::move(colors);
  ticks_ = std::move(ticks);
  levels_.clear();
  differences_ = true;
  difference_unit_ = unit;
  update();
}

void Legend::setReading(std::optional<double> lux) {
  if (lux == reading_) return;
  reading_ = lux;
  if (isVisible()) update();
}

void Legend::mousePressEvent(QMouseEvent* event) {
  event->accept();  // not a click into the view beneath
  if (event->button() == Qt::LeftButton) Q_EMIT editRequested();
}

QRectF Legend::bar() const {
  const int head = kMargin + fontMetrics().height() + 6;
  return {double{kMargin}, static_cast<double>(head), double{kBarWidth},
          static_cast<double>(height() - kMargin - head)};
}

void Legend::paintBar(QPainter& painter) const {
  const QRectF bar = this->bar();
  const int rows = static_cast<int>(std::lround(bar.height()));
  for (int i = 0; i < rows; ++i) {
    const float place = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(rows);
    painter.fillRect(QRectF(bar.left(), bar.top() + i, bar.width(), 1.0), toQt(colors_(place)));
  }
}

void Legend::paintTicks(QPainter& painter) const {
  const QRectF bar = this->bar();
  const int line = fontMetrics().height();
  painter.setPen(kInk);
  const QString unit =
      differences_ ? difference_unit_ : QString::fromLatin1(color::nameOf(scale_.unit));
  painter.drawText(QPointF(kMargin, kMargin + fontMetrics().ascent()), unit);
  const int room = std::max(2, static_cast<int>(bar.height()) / (line + 10));
  for (const color::LegendTick& tick : ticks_(room)) {
    const double y = bar.bottom() - static_cast<double>(tick.place) * bar.height();
    painter.drawLine(QPointF(bar.right() + 1, y), QPointF(bar.right() + 5, y));
    const double base = std::clamp(y + 0.5 * fontMetrics().ascent() - 1, bar.top() + 0.4 * line,
                                   bar.bottom() + 0.3 * line);
    QString label = QString::fromStdString(tick.label);
    label.replace(QLatin1Char('.'), QLocale().decimalPoint());
    painter.drawText(QPointF(bar.right() + 9, base), label);
  }
}

void Legend::paintMarks(QPainter& painter) const {
  if (differences_) return;
  const QRectF bar = this->bar();
  const auto heightOf = [&](double lux) {
    const float place = scale_.range.place(static_cast<float>(lux));
    return bar.bottom() - static_cast<double>(place) * bar.height();
  };
  for (const double level : levels_) {
    if (level < scale_.range.min || level > scale_.range.max) continue;
    const double y = heightOf(level);
    const bool light = toQt(scale_.color(static_cast<float>(level))).lightnessF() > 0.5F;
    painter.setPen(light ? Qt::black : Qt::white);
    painter.drawLine(QPointF(bar.left(), y), QPointF(bar.right() - 1, y));
  }
  if (!reading_) return;
  const double y = heightOf(*reading_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kInk);
  painter.drawPolygon(QPolygonF({QPointF(bar.left() - 1, y), QPointF(bar.left() - 9, y - kMark),
                                 QPointF(bar.left() - 9, y + kMark)}));
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kPlate);
  painter.drawRoundedRect(rect(), 6, 6);
  painter.setRenderHint(QPainter::Antialiasing, false);
  paintBar(painter);
  paintTicks(painter);
  paintMarks(painter);
}

}  // namespace soffit::ui
