// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QAbstractTableModel>

namespace soffit::ui {

/// The luminaires of the layout that is shown, a row each. All columns can be edited in place. An
/// edit of a row that is selected goes to all that are selected, and is one undo step: a value for
/// all, or `+=50`, `-=5 %`, `*=1.2` from each one's own.
class LightsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kDimming, kFlux, kColour, kGroup, kX, kY, kZ, kColumns };

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
  [[nodiscard]] QString textOf(int row, int column) const;
  [[nodiscard]] QVariant sortKeyOf(int row, int column) const;
  [[nodiscard]] QStringList targetsOf(const QModelIndex& index) const;
  void rename(const QString& from, const QString& to);
  void change(int column, const QString& text, const QStringList& names);

  Document* document_ = nullptr;
  std::vector<light::Luminaire> rows_;
  std::vector<double> flux_;  ///< per row
};

}  // namespace soffit::ui
