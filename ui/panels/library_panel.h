// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/library_model.h"

#include <QSortFilterProxyModel>
#include <QWidget>

class QLabel;
class QLineEdit;
class QListView;

namespace soffit::ui {

/// The library: kinds of luminaires to click or drag into the view, searched by all words that are
/// typed ("downlight 36°"). Folders of IES and LDT files are the user's own and are remembered.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(QWidget* parent = nullptr);

  [[nodiscard]] LibraryModel& model() { return model_; }
  [[nodiscard]] QStringList folders() const;
  void addFolder(const QString& folder);
  void setSearch(const QString& words);
  [[nodiscard]] int shownCount() const { return shown_.rowCount(); }

 Q_SIGNALS:
  /// A kind was clicked: it wants to be placed.
  void chosen(const LuminaireType& type);
  /// The folders were read through.
  void indexed(int unreadable);

 private:
  void reindex();
  void askFolder();

  LibraryModel model_;
  QSortFilterProxyModel shown_;
  LibraryIndex index_;
  QLineEdit* search_;
  QListView* list_;
  QLabel* state_;
};

}  // namespace soffit::ui
