// SPDX-License-Identifier: MIT
#include "ui/panels/results_model.h"

#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <QApplication>
#include <QFont>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

const QString kNone = QStringLiteral("\u2013");

QString lux(double value) {
  return formatReading(value, Dimension::illuminance);
}

}  // namespace

void ResultsModel::setReadings(ReadingsPtr readings) {
  std::vector<Row> rows;
  if (readings != nullptr) {
    for (std::size_t l = 0; l < readings->layouts.size(); ++l) {
      const std::size_t planes = readings->layouts[l].figures.planes.size();
      for (std::size_t p = 0; p < std::max<std::size_t>(planes, 1); ++p) rows.push_back({l, p});
    }
  }
  if (rows == rows_) {
    readings_ = std::move(readings);
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  readings_ = std::move(readings);
  rows_ = std::move(rows);
  endResetModel();
}

int ResultsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

std::optional<QString> ResultsModel::layoutAt(int row) const {
  if (row < 0 || row >= rowCount()) return std::nullopt;
  return toQt(readings_->layouts[rows_[static_cast<std::size_t>(row)].layout].layout);
}

int ResultsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(kColumns);
}

QString ResultsModel::fluxTextOf(const LayoutReading& reading, int column) const {
  const double area = readings_->area_m2;
  const bool power_known = reading.watts > 0.0;
  // Where some files declare no power, the sum is a lower bound.
  const QString about = reading.unknown_power > 0 ? QStringLiteral("\u2265\u00a0") : QString();
  switch (column) {
    case kFlux:
      return QString::number(std::lround(reading.figures.emitted_lm));
    case kFluxDensity:
      return area > 0.0 ? formatNumber(reading.figures.lm_per_m2, 0) : kNone;
    case kPower:
      return power_known ? about + formatNumber(reading.watts, 0) : kNone;
    default:
      return power_known && area > 0.0 ? about + formatNumber(reading.watts / area, 1) : kNone;
  }
}

QString ResultsModel::textOf(const Row& row, int column) const {
  const LayoutReading& reading = readings_->layouts[row.layout];
  if (column == kLayout) {
    return reading.layout.empty() ? tr("Base") : toQt(reading.layout);
  }
  if (column >= kFlux) return row.plane == 0 ? fluxTextOf(reading, column) : QString();
  if (row.plane >= reading.figures.planes.size()) return kNone;
  const auto& plane = reading.figures.planes[row.plane];
  switch (column) {
    case kPlane:
      return toQt(plane.name);
    case kMean:
      return lux(plane.lux.mean);
    case kMin:
      return lux(plane.lux.min);
    case kU0:
      return formatNumber(plane.lux.u0, 2);
    default:
      return lux(plane.lux.max);
  }
}

QVariant ResultsModel::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const LayoutReading& reading = readings_->layouts[row.layout];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(row, index.column());
    case Qt::TextAlignmentRole:
      return QVariant((index.column() <= kPlane ? Qt::AlignLeft : Qt::AlignRight) |
                      Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font = QApplication::font();
      font.setBold(reading.layout == readings_->shown);
      return font;
    }
    case Qt::ForegroundRole:
      if (reading.current) return {};
      return QApplication::palette().brush(QPalette::PlaceholderText);
    case Qt::ToolTipRole:
      if (index.column() >= kPower && reading.unknown_power > 0) {
        return tr("%n luminaire(s) whose photometric file declares no power are left out", nullptr,
                  static_cast<int>(reading.unknown_power));
      }
      return reading.current ? QVariant() : tr("Luminaires changed; the reading is under way");
    default:
      return {};
  }
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant((section <= kPlane ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  const QString lx = unitOf(Dimension::illuminance);
  const QString names[] = {tr("Layout"),          tr("Work plane"), tr("\u0112m %1").arg(lx),
                           tr("Emin %1").arg(lx), tr("U\u2080"),    tr("Emax %1").arg(lx),
                           tr("\u03a6 lm"),       tr("lm/m\u00b2"), tr("P W"),
                           tr("W/m\u00b2")};
  const QString hints[] = {tr("The layout in the view is in bold"),
                           tr("The grid of points that is read"),
                           tr("Mean illuminance (maintenance factor 1)"),
                           tr("Least illuminance of all points"),
                           tr("Uniformity: least over mean"),
                           tr("Greatest illuminance of all points"),
                           tr("Luminous flux of what is on, as it is dimmed"),
                           tr("Luminous flux over the area of all work planes"),
                           tr("Input power that the photometric files declare, times dimming"),
                           tr("Power over the area of all work planes")};
  if (role == Qt::DisplayRole) return names[section];
  if (role == Qt::ToolTipRole) return hints[section];
  return {};
}

}  // namespace soffit::ui
