// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/comparison_view.h"
#include "ui/main_window/view_grid.h"
#include "ui/viewport/error_map.h"
#include "ui/widgets/legend.h"

#include <QLabel>
#include <QWidget>

namespace soffit::ui {

/// The views with what lies over them: the legend of false colours, and a word while there is no
/// light yet. A comparison of layouts takes the place of all views but the first.
class ViewArea : public QWidget {
  Q_OBJECT

 public:
  explicit ViewArea(QWidget* parent = nullptr);

  [[nodiscard]] ViewGrid& grid() { return *grid_; }
  /// The first view, which is always there and speaks for all: its input repeats what the others'
  /// say.
  [[nodiscard]] SceneView& view() { return grid_->first().view(); }
  [[nodiscard]] ViewInput& input() { return grid_->first().input(); }
  /// The view that commands are for.
  [[nodiscard]] ViewPane& active() { return grid_->active(); }
  [[nodiscard]] ComparisonView& comparison() { return *comparison_; }
  [[nodiscard]] ErrorMap& errors() { return *errors_; }
  /// The scale of differences from -range to +range lux in place of the look's; 0: the look's.
  void setDifferenceScale(double range);
  /// Errors: SceneView::setLook()'s.
  Result<void> setLook(const Look& look);
  /// Empty: none.
  void setNotice(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void layOut();
  void showLegend();

  ViewGrid* grid_;
  ComparisonView* comparison_;
  ErrorMap* errors_;
  Legend* legend_;
  double difference_ = 0.0;
  QLabel* notice_;
};

}  // namespace soffit::ui
