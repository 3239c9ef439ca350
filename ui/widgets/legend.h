// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/false_color.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace soffit::ui {

/// The scale of a false-colour picture, to lay over a view: a bar with round values in lux.
class Legend : public QWidget {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent = nullptr);
  void setRange(const color::FalseColorRange& range);
  /// Any other scale in lux: its colors at 0..1 along the bar, and about so many round values.
  using Colors = std::function<vec3(float place)>;
  using Ticks = std::function<std::vector<color::LegendTick>(int most)>;
  void setScale(Colors colors, Ticks ticks);
  [[nodiscard]] QSize sizeHint() const override { return {92, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Colors colors_;
  Ticks ticks_;
};

}  // namespace soffit::ui
