// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringView>

#include <optional>

/// Quantities as people type them.
namespace soffit::ui {

/// What is measured; the unit in which values are kept stands behind it.
enum class Dimension {
  length /* m */,
  angle /* deg */,
  flux /* lm */,
  temperature /* K */,
  share /* 0..1, shown in % */,
  illuminance /* lx */,
  luminance /* cd/m2 */,
  exposure /* EV */
};

/// "m", "°", "lm", "K", "%", "lx", "cd/m²", "EV"; "ft" and "fc" where imperial units are shown (units.h).
QString unitOf(Dimension dimension);

/// The value of a text, with point or comma in every language: `1200`, `1200 lm`, `1.2 klm`, `3,2
/// m`, `320cm`, `10' 6"`, `40 deg`, `0.7 rad`, `50 %`, `46.5 fc`. A bare number is in the
/// dimension's shown unit. Nothing for what cannot be read, has another dimension's unit, or is not
/// finite.
std::optional<double> parseQuantity(QStringView text, Dimension dimension);

/// A bare number, written as printf's 'f' or 'g' does but with the decimal mark of the window's
/// language and without marks between thousands.
QString formatNumber(double value, int precision, char format = 'f');

/// What one shown unit is in the unit that values are kept in: 0.3048 where feet are shown.
double shownUnit(Dimension dimension);

/// Shown: at most `decimals` places of the kept unit, no trailing zeros, with the unit. Footcandles
/// get one place more.
QString formatQuantity(double value, Dimension dimension, int decimals);
/// The same without the unit.
QString formatNumber(double value, Dimension dimension, int decimals);

/// A reading for people: whole numbers from 100 on, three digits below; without the unit.
QString formatReading(double value, Dimension dimension);

}  // namespace soffit::ui
