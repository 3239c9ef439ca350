// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/readings.h"

#include <QAbstractTableModel>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace soffit::ui {

/// Two layouts against each other: a row per work plane and quantity, and the flux; the second
/// minus the first, and in percent of the first.
class DifferenceModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kPlane, kQuantity, kFirst, kSecond, kDifference, kPercent, kColumns };

  explicit DifferenceModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void setReadings(ReadingsPtr readings);
  /// Names of two layouts, empty for the base; nothing: none are compared.
  void setLayouts(const std::optional<std::pair<QString, QString>>& layouts);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  struct Row {
    QString plane;
    QString quantity;
    int decimals = 0;
    double first = 0.0;
    double second = 0.0;
    bool illuminance = false;  ///< lux, shown in the unit of the display
  };
  void refresh();
  void addRows(const LayoutReading& first, const LayoutReading& second, std::vector<Row>& rows);

  ReadingsPtr readings_;
  std::optional<std::pair<QString, QString>> layouts_;
  std::vector<Row> rows_;
};

}  // namespace soffit::ui
