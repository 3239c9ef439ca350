// SPDX-License-Identifier: MIT
#include "ui/widgets/theme.h"

#include "ui/widgets/theme_style.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>

#include <cmath>

namespace soffit::ui {
namespace {

const QString kKey = QStringLiteral("theme");

struct Tones {
  QColor window, base, raised, text, faint, line, accent;
};

/// Greys without a tint: next to a picture, any other colour would shift how its white is seen.
Tones tonesOf(bool dark) {
  if (dark) {
    return {QColor(45, 45, 47),    QColor(33, 33, 35), QColor(58, 58, 61),  QColor(228, 228, 230),
            QColor(140, 140, 144), QColor(24, 24, 26), QColor(214, 138, 32)};
  }
  return {QColor(240, 240, 241), QColor(255, 255, 255), QColor(248, 248, 249), QColor(28, 28, 30),
          QColor(120, 120, 124), QColor(196, 196, 200), QColor(174, 95, 4)};
}

/// Relative luminance of a color (WCAG 2.1).
double luminanceOf(const QColor& color) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

/// White or nearly black, whichever has more contrast.
QColor readableOn(const QColor& ground) {
  const QColor dark(16, 16, 18);
  const double g = luminanceOf(ground) + 0.05;
  return 1.05 / g > g / (luminanceOf(dark) + 0.05) ? QColor(Qt::white) : dark;
}

QPalette paletteOf(const Tones& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.window);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.base);
  p.setColor(QPalette::AlternateBase, t.window);
  p.setColor(QPalette::ToolTipBase, t.raised);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::PlaceholderText, t.faint);
  p.setColor(QPalette::Button, t.raised);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::BrightText, Qt::white);
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, readableOn(t.accent));
  // What Fusion draws lit edges with: next to nothing, as bright lines on dark ground glare.
  p.setColor(QPalette::Light, t.raised);
  p.setColor(QPalette::Midlight, t.raised);
  p.setColor(QPalette::Mid, t.line);
  p.setColor(QPalette::Dark, t.line);
  p.setColor(QPalette::Shadow, t.line);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, t.faint);
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, t.line);
  return p;
}

QString sheetOf(const Tones& t) {
  return QStringLiteral(
             "QToolTip { color: %1; background: %2; border: 1px solid %3; padding: 3px; }"
             "QDockWidget { font-weight: 600; }"
             "QDockWidget::title { background: %2; padding: 6px 8px; }"
             "QMainWindow::separator { background: %3; width: 4px; height: 4px; }"
             "QStatusBar { border-top: 1px solid %3; }"
             "QStatusBar::item { border: none; }"
             "QHeaderView::section { background: %2; border: none; border-right: 1px solid %3;"
             " border-bottom: 1px solid %3; padding: 4px 6px; }"
             "QTableView, QListView, QPlainTextEdit { border: none; }")
      .arg(t.text.name(), t.raised.name(), t.line.name());
}

}  // namespace

Theme savedTheme() {
  const QString name = QSettings().value(kKey).toString();
  if (name == QLatin1String("dark")) return Theme::dark;
  if (name == QLatin1String("light")) return Theme::light;
  return Theme::system;
}

void saveTheme(Theme theme) {
  const QString name = theme == Theme::dark    ? QStringLiteral("dark")
                       : theme == Theme::light ? QStringLiteral("light")
                                               : QStringLiteral("system");
  QSettings().setValue(kKey, name);
}

bool systemIsDark() {
  static const QPalette kSystem = QApplication::palette();
  return kSystem.color(QPalette::Window).lightness() <
         kSystem.color(QPalette::WindowText).lightness();
}

void applyTheme(Theme theme) {
  const bool dark = theme == Theme::dark || (theme == Theme::system && systemIsDark());
  const Tones tones = tonesOf(dark);
  QApplication::setStyle(new ThemeStyle);  // which owns it
  QApplication::setPalette(paletteOf(tones));
  qApp->setStyleSheet(sheetOf(tones));
}

}  // namespace soffit::ui
