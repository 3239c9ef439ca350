// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <vector>

class QToolButton;

namespace soffit::ui {

/// Illuminance along a line: a small chart to lay over a view, with mean, least and greatest value.
class ProfileChart : public QWidget {
  Q_OBJECT

 public:
  struct Point {
    double way = 0.0;  ///< m from the line's start, ascending
    double lux = 0.0;  ///< below 0: no lit surface there
  };

  explicit ProfileChart(QWidget* parent = nullptr);
  void setPoints(std::vector<Point> points);
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] QSize sizeHint() const override { return {360, 190}; }

 Q_SIGNALS:
  void closeRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QString summary() const;
  void paintAxes(QPainter& painter, const QRectF& plot, double most) const;
  void paintCurve(QPainter& painter, const QRectF& plot, double most) const;

  std::vector<Point> points_;
  QToolButton* close_;
};

}  // namespace soffit::ui
