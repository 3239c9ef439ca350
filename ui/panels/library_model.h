// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_types.h"
#include "ui/jobs/library_index.h"

#include <QAbstractListModel>
#include <QIcon>

#include <vector>

namespace soffit::ui {

/// The kinds of luminaires that can be placed: the built-in ones, then those of the user's folders.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit LibraryModel(QObject* parent = nullptr);

  void add(std::vector<LibraryEntry> entries);
  /// Back to the built-in ones.
  void dropUserTypes();
  [[nodiscard]] const LuminaireType& type(int row) const {
    return rows_[static_cast<std::size_t>(row)].type;
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;

 private:
  struct Row {
    LuminaireType type;
    QString facts;  ///< second line of those that have a path
    QString path;   ///< tool tip; empty for built-in ones
    mutable QIcon icon;
  };
  [[nodiscard]] const QIcon& iconOf(const Row& row) const;
  [[nodiscard]] static QString textOf(const Row& row);

  std::vector<Row> rows_;
  std::size_t built_in_ = 0;
};

/// The light distribution curve of a kind as a thumbnail.
QImage thumbnailOf(const LuminaireType& type, int pixels);

}  // namespace soffit::ui
