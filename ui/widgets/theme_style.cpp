// SPDX-License-Identifier: MIT
#include "ui/widgets/theme_style.h"

#include <QListView>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr int kListAir = 4;  // px

void drawCheckBox(const QStyleOption& option, QPainter& painter) {
  const QPalette& palette = option.palette;
  const bool enabled = (option.state & QStyle::State_Enabled) != 0;
  const bool ticked = (option.state & QStyle::State_On) != 0;
  const bool partial = (option.state & QStyle::State_NoChange) != 0;
  const QPalette::ColorGroup group = enabled ? QPalette::Active : QPalette::Disabled;
  const double side = std::min(option.rect.width(), option.rect.height()) - 1.0;
  QRectF box(0.0, 0.0, side, side);
  box.moveCenter(QRectF(option.rect).center());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
  // On a selected row the accent is the ground.
  const bool selected = (option.state & QStyle::State_Selected) != 0;
  const bool filled = enabled && !selected && (ticked || partial);
  const QColor frame = palette.color(selected ? QPalette::Text : QPalette::PlaceholderText);
  painter.setPen(QPen(filled ? accent : frame, 1.2));
  painter.setBrush(filled ? accent : palette.color(QPalette::Base));
  painter.drawRoundedRect(box, 2.5, 2.5);
  painter.setPen(QPen(filled ? QColor(Qt::white) : palette.color(group, QPalette::Text),
                      0.14 * side, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const auto at = [&](double x, double y) { return box.topLeft() + side * QPointF(x, y); };
  if (ticked) {
    const QPointF tick[] = {at(0.23, 0.53), at(0.43, 0.73), at(0.78, 0.29)};
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(tick, 3);
  } else if (partial) {
    painter.drawLine(at(0.26, 0.5), at(0.74, 0.5));
  }
  painter.restore();
}

/// A button that is on.
void drawPressed(const QStyleOption& option, QPainter& painter) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QColor fill = option.palette.color(QPalette::Active, QPalette::Highlight);
  painter.setPen(QPen(fill, 1.0));
  fill.setAlpha(150);
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
  painter.restore();
}

}  // namespace

ThemeStyle::ThemeStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const {
  if (element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck) {
    drawCheckBox(*option, *painter);
    return;
  }
  if (element == PE_PanelButtonTool && (option->state & State_On) != 0) {
    drawPressed(*option, *painter);
    return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* data) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, data);
}

QSize ThemeStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
  QSize full = QProxyStyle::sizeFromContents(type, option, size, widget);
  if (type == CT_ItemViewItem && qobject_cast<const QListView*>(widget) != nullptr) {
    full.rheight() += kListAir;
  }
  return full;
}

}  // namespace soffit::ui
