// SPDX-License-Identifier: MIT
#include "ui/widgets/slider_box.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>
#include <utility>

namespace soffit::ui {

SliderBox::SliderBox(Dimension dimension, double least, double most, double step, QWidget* parent)
    : QWidget(parent),
      step_(step),
      slider_(new QSlider(Qt::Horizontal)),
      box_(new QuantityBox(dimension)) {
  slider_->setRange(static_cast<int>(std::lround(least / step)),
                    static_cast<int>(std::lround(most / step)));
  slider_->setMinimumWidth(50);
  box_->setRange(least, most);
  box_->setSteps(step, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(slider_, 1);
  layout->addWidget(box_);
  connect(slider_, &QSlider::valueChanged, this, [this](int steps) {
    const double value = steps * step_;
    if (slider_->isSliderDown()) {
      moved_ = true;
      Q_EMIT held(value);
    } else {
      Q_EMIT edited(value);
    }
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] {
    if (std::exchange(moved_, false)) Q_EMIT released();
  });
  connect(box_, &QuantityBox::edited, this, &SliderBox::edited);
}

void SliderBox::setValue(double value) {
  box_->setValue(value);
  if (slider_->isSliderDown()) return;  // in the user's hand
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(value / step_)));
}

void SliderBox::setName(const QString& name) {
  slider_->setAccessibleName(name);
  box_->setAccessibleName(name);
}

}  // namespace soffit::ui
