// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/readings.h"

#include <QAbstractTableModel>

#include <optional>

namespace soffit::ui {

/// The readings as a table: a row per layout and work plane, the flux and the power of a layout in
/// its first row. Rows keep their place while values change, so that a drag only repaints.
class ResultsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    kLayout,
    kPlane,
    kMean,
    kMin,
    kU0,
    kMax,
    kFlux,
    kFluxDensity,
    kPower,
    kPowerDensity,
    kColumns
  };

  explicit ResultsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  /// Null: nothing.
  void setReadings(ReadingsPtr readings);
  [[nodiscard]] const ReadingsPtr& readings() const { return readings_; }

  /// The layout of a row, empty for the base; nothing for a row that is not there.
  [[nodiscard]] std::optional<QString> layoutAt(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  struct Row {
    std::size_t layout = 0;
    std::size_t plane = 0;
    bool operator==(const Row&) const = default;
  };
  [[nodiscard]] QString textOf(const Row& row, int column) const;
  [[nodiscard]] QString fluxTextOf(const LayoutReading& reading, int column) const;

  ReadingsPtr readings_;
  std::vector<Row> rows_;
};

}  // namespace soffit::ui
