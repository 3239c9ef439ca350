// SPDX-License-Identifier: MIT
#pragma once

#include <QProxyStyle>

namespace soffit::ui {

/// Fusion with check boxes that can be seen, ticked or not, on dark and light grounds (its own
/// frame is darker than the window, which on a dark one is nothing), and with buttons that show
/// that they are on.
class ThemeStyle : public QProxyStyle {
 public:
  ThemeStyle();
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  /// No icons on the buttons of dialogs.
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override;
  /// Rows of lists have air.
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
};

}  // namespace soffit::ui
