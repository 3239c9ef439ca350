// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/verify.h"
#include "core/math/vec.h"

#include <QString>
#include <QWidget>

#include <vector>

namespace soffit::ui {

class Legend;
class SceneView;

/// A point that was verified.
struct ErrorPoint {
  dvec3 position{0.0};  ///< world
  dvec3 normal{0.0};    ///< unit
  double error = 0.0;   ///< computed - reference, over max(reference, 5 % of its set's mean)
  double noise = 0.0;   ///< standard error of the reference, over the same
};

/// The points of a report, each relative to its own set: lit surfaces, or its work plane.
std::vector<ErrorPoint> errorPointsOf(const design::VerifyReport& report);

/// A round share (0.01, 0.02, 0.05 ... 1) that covers all but five percent of the errors.
double fittingErrorScale(const std::vector<ErrorPoint>& points);

/// Errors of single points over a view: discs in the surfaces, blue where the computed light is too
/// dark and orange where it is too bright. Hollow ones lie within twice the reference's noise.
/// What is hidden by surfaces is not drawn.
class ErrorMap : public QWidget {
  Q_OBJECT

 public:
  /// with_legend: of several views with the same points one has it.
  explicit ErrorMap(SceneView& view, bool with_legend = true);
  /// Empty: none.
  void setPoints(std::vector<ErrorPoint> points);
  [[nodiscard]] const std::vector<ErrorPoint>& points() const { return points_; }
  /// How many were drawn last.
  [[nodiscard]] int drawn() const { return drawn_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] bool isSeen(const ErrorPoint& point) const;
  void paintPoint(QPainter& painter, const ErrorPoint& point) const;

  SceneView& view_;
  Legend* legend_;
  std::vector<ErrorPoint> points_;
  double radius_ = 0.1;  ///< m
  double scale_ = 0.1;   ///< error at either end of the colours
  int drawn_ = 0;
};

}  // namespace soffit::ui
