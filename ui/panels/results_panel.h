// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/difference_model.h"
#include "ui/panels/results_model.h"

#include <QWidget>

#include <optional>
#include <utility>

class QLabel;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace soffit::ui {

/// What the work planes read, layout by layout, as the light changes.
class ResultsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultsPanel(QWidget* parent = nullptr);
  /// Null: nothing is open, or there is no light yet.
  void setReadings(ReadingsPtr readings);
  [[nodiscard]] const ReadingsPtr& readings() const { return model_.readings(); }
  /// Also shows the second layout against the first; nothing: all layouts alone.
  void setComparison(const std::optional<std::pair<QString, QString>>& layouts);
  /// The table as tab-separated text: the rows selected, else all.
  [[nodiscard]] QString text() const;
  /// The same into the clipboard.
  void copy() const;

 Q_SIGNALS:
  void exportRequested();
  /// A row was double-clicked: its layout, empty for the base.
  void layoutChosen(const QString& layout);

 private:
  void showState();
  [[nodiscard]] QTableView* table() const;

  ResultsModel model_;
  DifferenceModel difference_;
  QStackedWidget* tables_;
  QTableView* all_;
  QTableView* pair_;
  QToolButton* against_;
  QLabel* state_;
  QToolButton* copy_;
  QToolButton* export_;
};

}  // namespace soffit::ui
