// SPDX-License-Identifier: MIT
#pragma once

#include "ui/widgets/quantity.h"

#include <QAbstractSpinBox>

#include <optional>

namespace soffit::ui {

/// A box for a number with its unit that takes any unit of its kind: `1200 lm`, `320 cm`, `40 deg`.
///
/// Arrow keys and wheel step; Return or leaving the box takes the text. What cannot be read is
/// turned down and the old value comes back. Can be empty: several things with different values.
class QuantityBox : public QAbstractSpinBox {
  Q_OBJECT

 public:
  explicit QuantityBox(Dimension dimension, QWidget* parent = nullptr);

  void setRange(double least, double most);
  void setSteps(double single, int decimals);
  /// Shows a value; nothing: "mixed". Sends no signal.
  void setValue(std::optional<double> value);
  /// What an empty box says; "mixed" unless told otherwise.
  void setEmptyText(const QString& text);
  [[nodiscard]] std::optional<double> value() const { return value_; }

  void stepBy(int steps) override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  /// The user gave another value.
  void edited(double value);

 protected:
  [[nodiscard]] StepEnabled stepEnabled() const override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void takeText();
  void showValue();
  void give(double value);
  [[nodiscard]] double shownStep() const;

  Dimension dimension_;
  std::optional<double> value_;
  double least_ = -1e7;
  double most_ = 1e7;
  double step_ = 0.1;
  int decimals_ = 3;
};

}  // namespace soffit::ui
