// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/comparison_view.h"
#include "ui/main_window/view_pane.h"
#include "ui/widgets/legend.h"

#include <QLabel>
#include <QWidget>

namespace soffit::ui {

/// The view with what lies over it: the legend of false colours, and a word while there is no light
/// yet.
class ViewArea : public QWidget {
  Q_OBJECT

 public:
  explicit ViewArea(QWidget* parent = nullptr);

  [[nodiscard]] SceneView& view() { return pane_->view(); }
  [[nodiscard]] ViewInput& input() { return pane_->input(); }
  [[nodiscard]] ViewPane& pane() { return *pane_; }
  [[nodiscard]] ComparisonView& comparison() { return *comparison_; }
  /// The scale of differences from -range to +range lux in place of the look's; 0: the look's.
  void setDifferenceScale(double range);
  /// Errors: SceneView::setLook()'s.
  Result<void> setLook(const Look& look);
  /// Empty: none.
  void setNotice(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void layOut();
  void showLegend();

  ViewPane* pane_;
  ComparisonView* comparison_;
  Legend* legend_;
  double difference_ = 0.0;
  QLabel* notice_;
};

}  // namespace soffit::ui
