// SPDX-License-Identifier: MIT
#include "ui/widgets/legend.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kMargin = 12;
constexpr int kBarWidth = 16;

QColor toQt(const vec3& c) {
  return QColor::fromRgbF(c.x, c.y, c.z);
}

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Scale of illuminance"));
  setRange({});
}

void Legend::setRange(const color::FalseColorRange& range) {
  setScale(color::falseColorAt, [range](int most) { return color::legendTicks(range, most); });
}

void Legend::setScale(Colors colors, Ticks ticks) {
  colors_ = std::move(colors);
  ticks_ = std::move(ticks);
  update();
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 190));
  painter.drawRoundedRect(rect(), 6, 6);
  const int line = fontMetrics().height();
  const QRectF bar(kMargin, kMargin + line + 6, kBarWidth, height() - 2 * kMargin - line - 6);
  const int rows = static_cast<int>(std::lround(bar.height()));
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int i = 0; i < rows; ++i) {
    const float place = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(rows);
    painter.fillRect(QRectF(bar.left(), bar.top() + i, bar.width(), 1.0), toQt(colors_(place)));
  }
  painter.setPen(QColor(238, 240, 244));
  painter.drawText(QPointF(kMargin, kMargin + fontMetrics().ascent()), QStringLiteral("lx"));
  const int room = std::max(2, rows / (line + 10));
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

}  // namespace soffit::ui
