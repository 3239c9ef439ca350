// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_array.h"
#include "ui/widgets/quantity_box.h"

#include <QFrame>

class QComboBox;
class QLabel;
class QSpinBox;

namespace soffit::ui {

/// The numbers of an array that is being made, to lay over the view.
class ArrayBar : public QFrame {
  Q_OBJECT

 public:
  explicit ArrayBar(QWidget* parent);
  /// wanted: as it was asked for; a spacing of 0 follows the count.
  void showPlan(const ArrayPlan& plan, const ArraySettings& wanted);

 Q_SIGNALS:
  void changed(const ArraySettings& settings);
  void applied();
  void cancelled();

 private:
  void tell();

  ArraySettings settings_;
  QComboBox* kind_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QuantityBox* spacing_x_;
  QuantityBox* spacing_y_;
  QuantityBox* radius_;
  QLabel* times_;
  QLabel* walls_;
};

}  // namespace soffit::ui
