// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/lux_scale.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

namespace soffit::ui {

/// The scale that false colours, isolux lines and numbers of a view share, to lay over it: a bar
/// with round values, the lines' levels, and a mark at the reading under the cursor. A click asks
/// for the scale to be edited.
class Legend : public QWidget {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent = nullptr);
  /// levels: of isolux lines, lux.
  void setScale(const color::LuxScale& scale, std::vector<double> levels = {});
  /// A scale of differences: its colors at 0..1 along the bar, about so many values, and what
  /// stands above them; empty: their labels say it.
  using Colors = std::function<vec3(float place)>;
  using Ticks = std::function<std::vector<color::LegendTick>(int most)>;
  void setScale(Colors colors, Ticks ticks, const QString& unit = QStringLiteral("lx"));
  /// Lux under the cursor; nothing: no mark.
  void setReading(std::optional<double> lux);
  [[nodiscard]] const color::LuxScale& scale() const { return scale_; }
  [[nodiscard]] QSize sizeHint() const override { return {92, 300}; }

 Q_SIGNALS:
  void editRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QRectF bar() const;
  void paintBar(QPainter& painter) const;
  void paintTicks(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;

  color::LuxScale scale_;
  Colors colors_;
  Ticks ticks_;
  std::vector<double> levels_;
  bool differences_ = false;
  QString difference_unit_;
  std::optional<double> reading_;
};

}  // namespace soffit::ui
