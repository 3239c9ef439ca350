// SPDX-License-Identifier: MIT
#include "ui/widgets/value_change.h"

#include <algorithm>

namespace soffit::ui {

std::optional<std::function<double(double)>> parseChange(QStringView text, Dimension dimension,
                                                         double least) {
  const QStringView trimmed = text.trimmed();
  const QStringView rest = trimmed.mid(2);
  if (trimmed.startsWith(QLatin1String("*="))) {
    bool ok = false;
    const double factor =
        rest.trimmed().toString().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    if (!ok || factor < 0.0) return std::nullopt;
    return [factor, least](double v) { return std::max(factor * v, least); };
  }
  const bool plus = trimmed.startsWith(QLatin1String("+="));
  if (plus || trimmed.startsWith(QLatin1String("-="))) {
    const auto step = parseQuantity(rest, dimension);
    if (!step) return std::nullopt;
    return [by = plus ? *step : -*step, least](double v) { return std::max(v + by, least); };
  }
  const auto value = parseQuantity(trimmed, dimension);
  if (!value || *value < least) return std::nullopt;
  return [v = *value](double) { return v; };
}

}  // namespace soffit::ui
