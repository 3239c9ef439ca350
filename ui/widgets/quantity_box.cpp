// SPDX-License-Identifier: MIT
#include "ui/widgets/quantity_box.h"

#include "ui/widgets/units.h"

#include <QLineEdit>
#include <QWheelEvent>

#include <algorithm>

namespace soffit::ui {

QuantityBox::QuantityBox(Dimension dimension, QWidget* parent)
    : QAbstractSpinBox(parent), dimension_(dimension) {
  setKeyboardTracking(false);
  setFocusPolicy(
      Qt::StrongFocus);  // the wheel scrolls the panel, not a box that happens to be there
  setAccelerated(true);
  lineEdit()->setAlignment(Qt::AlignRight);
  lineEdit()->setPlaceholderText(tr("mixed"));
  connect(this, &QAbstractSpinBox::editingFinished, this, &QuantityBox::takeText);
}

void QuantityBox::setRange(double least, double most) {
  least_ = least;
  most_ = most;
}

void QuantityBox::setSteps(double single, int decimals) {
  step_ = single;
  decimals_ = decimals;
}

void QuantityBox::setEmptyText(const QString& text) {
  lineEdit()->setPlaceholderText(text);
}

void QuantityBox::setValue(std::optional<double> value) {
  if (lineEdit()->isModified() && hasFocus() && value == value_) return;
  value_ = value;
  showValue();
}

void QuantityBox::showValue() {
  const QSignalBlocker quiet(lineEdit());
  lineEdit()->setText(value_ ? formatQuantity(*value_, dimension_, decimals_) : QString());
  update();
}

void QuantityBox::give(double value) {
  value = std::clamp(value, least_, most_);
  const bool changed = !value_ || *value_ != value;
  value_ = value;
  showValue();
  if (changed) Q_EMIT edited(value);
}

void QuantityBox::takeText() {
  const QString text = lineEdit()->text();
  if (value_ && text == formatQuantity(*value_, dimension_, decimals_)) return;
  if (!value_ && text.trimmed().isEmpty()) return;
  const auto read = parseQuantity(text, dimension_);
  if (read) {
    give(*read);
  } else {
    showValue();
  }
}

void QuantityBox::stepBy(int steps) {
  takeText();
  give(value_.value_or(0.0) + steps * shownStep());
  lineEdit()->selectAll();
}

/// A tenth of a metre becomes a tenth of a foot, 50 lx become 5 fc: round numbers stay round.
double QuantityBox::shownStep() const {
  if (shownUnits() == Units::metric) return step_;
  if (dimension_ == Dimension::illuminance) return 0.1 * step_ * shownUnit(dimension_);
  return dimension_ == Dimension::length ? step_ * shownUnit(dimension_) : step_;
}

void QuantityBox::changeEvent(QEvent* event) {
  QAbstractSpinBox::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) showValue();
}

QAbstractSpinBox::StepEnabled QuantityBox::stepEnabled() const {
  StepEnabled enabled = StepNone;
  if (!value_ || *value_ < most_) enabled |= StepUpEnabled;
  if (!value_ || *value_ > least_) enabled |= StepDownEnabled;
  return enabled;
}

void QuantityBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QAbstractSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

QSize QuantityBox::sizeHint() const {
  QSize size = QAbstractSpinBox::sizeHint();
  size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-00.000 ft")) + 34);
  return size;
}

}  // namespace soffit::ui
