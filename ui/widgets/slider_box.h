// SPDX-License-Identifier: MIT
#pragma once

#include "ui/widgets/quantity_box.h"

#include <QWidget>

class QSlider;

namespace soffit::ui {

/// A slider with a box for exact values. While the slider is held, values are told apart from those
/// that stay: what follows them may be quick and rough.
class SliderBox : public QWidget {
  Q_OBJECT

 public:
  /// least, most: of the slider; the box may have a wider range.   step: of the slider.
  SliderBox(Dimension dimension, double least, double most, double step, QWidget* parent = nullptr);

  /// Sends no signal.
  void setValue(double value);
  [[nodiscard]] QuantityBox* box() { return box_; }
  [[nodiscard]] QSlider* slider() { return slider_; }
  /// For the slider, whose label belongs to the row.
  void setName(const QString& name);

 Q_SIGNALS:
  void held(double value);
  void released();
  void edited(double value);

 private:
  double step_;
  QSlider* slider_;
  QuantityBox* box_;
  bool moved_ = false;  ///< since it was pressed
};

}  // namespace soffit::ui
