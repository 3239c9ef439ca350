// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QAbstractTableModel>

namespace soffit::ui {

/// The luminaires of the layout that is shown, a row each. On, group, dimming, flux and colour
/// temperature can be edited in place; each edit is an undo step.
class LightsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kDimming, kFlux, kColour, kGroup, kColumns };

  explicit LightsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void setDocument(Document* document);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// What rows are sorted by, in the role Qt::UserRole.
  [[nodiscard]] QString nameAt(int row) const;
  [[nodiscard]] int rowOf(const QString& name) const;

 private:
  void refresh();
  [[nodiscard]] QString textOf(const light::Luminaire& luminaire, int column) const;
  [[nodiscard]] QVariant sortKeyOf(const light::Luminaire& luminaire, int column) const;

  Document* document_ = nullptr;
  std::vector<light::Luminaire> rows_;
  std::vector<double> flux_;  ///< per row
};

}  // namespace soffit::ui
