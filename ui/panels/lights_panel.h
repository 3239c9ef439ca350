// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/lights_model.h"

#include <QSortFilterProxyModel>
#include <QWidget>

class QLineEdit;
class QTableView;

namespace soffit::ui {

/// The list of luminaires: sorted, filtered, edited in place; its selection is the document's.
class LightsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LightsPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);

 private:
  void showSelection();
  void takeSelection();

  Document* document_ = nullptr;
  LightsModel model_;
  QSortFilterProxyModel sorted_;
  QLineEdit* filter_;
  QTableView* table_;
  bool following_ = false;
};

}  // namespace soffit::ui
