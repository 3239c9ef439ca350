// SPDX-License-Identifier: MIT
#include "ui/widgets/quantity.h"

#include "ui/widgets/units.h"

#include <QLocale>
#include <QRegularExpression>

#include <array>
#include <cmath>

namespace soffit::ui {
namespace {

struct Unit {
  const char* name;
  Dimension dimension;
  double factor;  ///< to the kept unit
};

constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr std::array kUnits{Unit{"m", Dimension::length, 1.0},
                            Unit{"cm", Dimension::length, 0.01},
                            Unit{"mm", Dimension::length, 0.001},
                            Unit{"ft", Dimension::length, 0.3048},
                            Unit{"'", Dimension::length, 0.3048},
                            Unit{"in", Dimension::length, 0.0254},
                            Unit{"\"", Dimension::length, 0.0254},
                            Unit{"deg", Dimension::angle, 1.0},
                            Unit{"\u00b0", Dimension::angle, 1.0},
                            Unit{"rad", Dimension::angle, kDegreesPerRadian},
                            Unit{"lm", Dimension::flux, 1.0},
                            Unit{"klm", Dimension::flux, 1000.0},
                            Unit{"k", Dimension::temperature, 1.0},
                            Unit{"%", Dimension::share, 0.01},
                            Unit{"lx", Dimension::illuminance, 1.0},
                            Unit{"lux", Dimension::illuminance, 1.0},
                            Unit{"klx", Dimension::illuminance, 1000.0},
                            Unit{"fc", Dimension::illuminance, color::kLuxPerFootcandle},
                            Unit{"cd/m\u00b2", Dimension::luminance, 1.0},
                            Unit{"cd/m2", Dimension::luminance, 1.0},
                            Unit{"kcd/m\u00b2", Dimension::luminance, 1000.0},
                            Unit{"kcd/m2", Dimension::luminance, 1000.0},
                            Unit{"nit", Dimension::luminance, 1.0},
                            Unit{"ev", Dimension::exposure, 1.0}};

std::optional<double> factorOf(const QString& unit, Dimension dimension) {
  if (unit.isEmpty()) return shownUnit(dimension);
  for (const Unit& u : kUnits) {
    if (u.dimension == dimension && unit == QString::fromUtf8(u.name)) return u.factor;
  }
  return std::nullopt;
}

}  // namespace

double shownUnit(Dimension dimension) {
  if (dimension == Dimension::share) return 0.01;
  if (shownUnits() == Units::metric) return 1.0;
  if (dimension == Dimension::length) return kMetresPerFoot;
  return dimension == Dimension::illuminance ? color::kLuxPerFootcandle : 1.0;
}

QString unitOf(Dimension dimension) {
  const bool imperial = shownUnits() == Units::imperial;
  switch (dimension) {
    case Dimension::length:
      return imperial ? QStringLiteral("ft") : QStringLiteral("m");
    case Dimension::angle:
      return QStringLiteral("\u00b0");
    case Dimension::flux:
      return QStringLiteral("lm");
    case Dimension::temperature:
      return QStringLiteral("K");
    case Dimension::share:
      return QStringLiteral("%");
    case Dimension::illuminance:
      return imperial ? QStringLiteral("fc") : QStringLiteral("lx");
    case Dimension::luminance:
      return QStringLiteral("cd/m\u00b2");
    case Dimension::exposure:
      return QStringLiteral("EV");
  }
  return {};
}

std::optional<double> parseQuantity(QStringView text, Dimension dimension) {
  // Feet and inches are two terms of one length: 10' 6".
  static const QRegularExpression kTerm(
      QStringLiteral("\\G\\s*([+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:e[+-]?\\d+)?)\\s*(k?cd/"
                     "m[2\u00b2]|[a-z%\u00b0'\"]*)"),
      QRegularExpression::CaseInsensitiveOption);
  QString cleaned = text.toString().toLower();
  cleaned.replace(QChar(0x2212), QLatin1Char('-'));  // a typographer's minus
  cleaned.replace(QChar::Nbsp, QLatin1Char(' '));    // formatQuantity()'s
  cleaned = cleaned.trimmed();
  double sum = 0.0;
  int terms = 0;
  qsizetype at = 0;
  while (at < cleaned.size()) {
    const auto match = kTerm.match(cleaned, at);
    if (!match.hasMatch()) return std::nullopt;
    bool ok = false;
    const double number =
        match.captured(1).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    const auto factor = factorOf(match.captured(2), dimension);
    if (!ok || !factor || !std::isfinite(number)) return std::nullopt;
    if (terms > 0 && (match.captured(2).isEmpty() || dimension != Dimension::length)) {
      return std::nullopt;
    }
    sum += number * *factor;
    ++terms;
    at = match.capturedEnd();
  }
  return terms > 0 ? std::optional(sum) : std::nullopt;
}

QString formatNumber(double value, int precision, char format) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, format, precision);
}

QString formatNumber(double value, Dimension dimension, int decimals) {
  const bool coarse = dimension == Dimension::illuminance && shownUnits() == Units::imperial;
  if (coarse) ++decimals;
  // Times 100 rather than by 0.01: shares of whole percents stay whole.
  const double shown = dimension == Dimension::share ? 100.0 * value : value / shownUnit(dimension);
  QString number = formatNumber(shown, decimals);
  const QString mark = QLocale().decimalPoint();
  if (number.contains(mark)) {
    while (number.endsWith(QLatin1Char('0'))) number.chop(1);
    if (number.endsWith(mark)) number.chop(mark.size());
  }
  if (number == QLatin1String("-0")) number = QStringLiteral("0");
  return number;
}

QString formatReading(double value, Dimension dimension) {
  const double shown = value / shownUnit(dimension);
  if (shown == 0.0) return QStringLiteral("0");
  if (shown >= 99.95) return formatNumber(shown, 0);
  return formatNumber(shown, shown >= 9.995 ? 1 : 2);
}

QString formatQuantity(double value, Dimension dimension, int decimals) {
  const QString number = formatNumber(value, dimension, decimals);
  const QString gap = dimension == Dimension::angle ? QString() : QStringLiteral("\u00a0");
  return number + gap + unitOf(dimension);
}

}  // namespace soffit::ui
