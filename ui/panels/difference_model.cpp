// SPDX-License-Identifier: MIT
#include "ui/panels/difference_model.h"

#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

const LayoutReading* find(const Readings& readings, const QString& layout) {
  const auto found = std::ranges::find(readings.layouts, toStd(layout), &LayoutReading::layout);
  return found == readings.layouts.end() ? nullptr : &*found;
}

/// With its sign; what rounds to nothing has none.
QString difference(double value, int decimals) {
  QString text = formatNumber(std::abs(value), decimals);
  if (text == formatNumber(0.0, decimals)) return text;
  return (value > 0.0 ? QStringLiteral("+") : QStringLiteral("\u2212")) + text;
}

}  // namespace

void DifferenceModel::setReadings(ReadingsPtr readings) {
  readings_ = std::move(readings);
  refresh();
}

void DifferenceModel::setLayouts(const std::optional<std::pair<QString, QString>>& layouts) {
  if (layouts == layouts_) return;
  layouts_ = layouts;
  refresh();
  Q_EMIT headerDataChanged(Qt::Horizontal, kFirst, kSecond);
}

void DifferenceModel::addRows(const LayoutReading& first, const LayoutReading& second,
                              std::vector<Row>& rows) {
  const auto& a = first.figures;
  const auto& b = second.figures;
  for (std::size_t p = 0; p < std::min(a.planes.size(), b.planes.size()); ++p) {
    const photometry::FieldMetrics& x = a.planes[p].lux;
    const photometry::FieldMetrics& y = b.planes[p].lux;
    const QString plane = toQt(a.planes[p].name);
    rows.push_back({plane, tr("\u0112m"), 1, x.mean, y.mean, true});
    rows.push_back({plane, tr("Emin"), 1, x.min, y.min, true});
    rows.push_back({plane, tr("U\u2080"), 2, x.u0, y.u0});
    rows.push_back({plane, tr("Emax"), 1, x.max, y.max, true});
  }
  rows.push_back({tr("All"), tr("\u03a6 lm"), 0, a.emitted_lm, b.emitted_lm});
  if (a.lm_per_m2 > 0.0 || b.lm_per_m2 > 0.0) {
    rows.push_back({tr("All"), tr("lm/m\u00b2"), 0, a.lm_per_m2, b.lm_per_m2});
  }
  if (first.watts > 0.0 && second.watts > 0.0 && first.unknown_power + second.unknown_power == 0) {
    rows.push_back({tr("All"), tr("P W"), 0, first.watts, second.watts});
  }
}

void DifferenceModel::refresh() {
  std::vector<Row> rows;
  if (readings_ != nullptr && layouts_) {
    const LayoutReading* first = find(*readings_, layouts_->first);
    const LayoutReading* second = find(*readings_, layouts_->second);
    if (first != nullptr && second != nullptr) addRows(*first, *second, rows);
  }
  if (rows.size() == rows_.size()) {
    rows_ = std::move(rows);
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int DifferenceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DifferenceModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(kColumns);
}

QVariant DifferenceModel::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return QVariant((index.column() < kFirst ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  const double unit = row.illuminance ? shownUnit(Dimension::illuminance) : 1.0;
  switch (index.column()) {
    case kPlane:
      return row.plane;
    case kQuantity:
      return row.illuminance ? row.quantity + QLatin1Char(' ') + unitOf(Dimension::illuminance)
                             : row.quantity;
    case kFirst:
      return formatNumber(row.first / unit, row.decimals);
    case kSecond:
      return formatNumber(row.second / unit, row.decimals);
    case kDifference:
      return difference((row.second - row.first) / unit, row.decimals);
    default:
      if (row.first == 0.0) return QStringLiteral("\u2013");
      return difference(100.0 * (row.second / row.first - 1.0), 1);
  }
}

QVariant DifferenceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant((section < kFirst ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  const auto name = [](const QString& layout) { return layout.isEmpty() ? tr("Base") : layout; };
  switch (section) {
    case kPlane:
      return tr("Work plane");
    case kQuantity:
      return tr("Quantity");
    case kFirst:
      return layouts_ ? name(layouts_->first) : tr("First");
    case kSecond:
      return layouts_ ? name(layouts_->second) : tr("Second");
    case kDifference:
      return tr("Difference");
    default:
      return QStringLiteral("%");
  }
}

}  // namespace soffit::ui
