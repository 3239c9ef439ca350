// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/comparison_view.h"
#include "ui/main_window/view_grid.h"
#include "ui/viewport/error_map.h"
#include "ui/viewport/lux_overlay.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/profile_chart.h"

#include <QLabel>
#include <QWidget>

#include <vector>

namespace soffit::ui {

/// The views with what lies over them: numbers of light with their legend, and a word while there
/// is no light yet. A comparison of layouts takes the place of all views but the first.
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
  /// Of the i-th view of the grid.
  [[nodiscard]] ErrorMap& errors(std::size_t i = 0) { return *overlays_[i].errors; }
  [[nodiscard]] LuxOverlay& marks(std::size_t i = 0) { return *overlays_[i].marks; }
  /// The scale of differences from -range to +range lux in place of the look's; 0: the look's.
  void setDifferenceScale(double range);
  [[nodiscard]] ProfileChart& profile() { return *profile_; }
  [[nodiscard]] Legend& legend() { return *legend_; }
  /// levels: of the isolux lines on work planes, lux. The legend is there where its scale is used.
  /// Errors: SceneView::setLook()'s.
  Result<void> setLook(const Look& look, const std::vector<double>& levels, bool values);
  /// Empty: none.
  void setNotice(const QString& text);

 Q_SIGNALS:
  /// The scale of illuminance is to be edited.
  void scaleRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// What lies over a view.
  struct Overlay {
    ErrorMap* errors = nullptr;
    LuxOverlay* marks = nullptr;
  };
  void addOverlays();
  void layOut();
  void showLegend();

  ViewGrid* grid_;
  ComparisonView* comparison_;
  std::vector<Overlay> overlays_;  ///< per view that there has been
  Legend* legend_;
  ProfileChart* profile_;
  std::vector<double> plane_levels_;
  bool plane_values_ = false;
  double difference_ = 0.0;
  QLabel* notice_;
};

}  // namespace soffit::ui
