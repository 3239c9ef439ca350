// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <QWidget>

#include <functional>

class QComboBox;

namespace soffit::ui {

class QuantityBox;

/// What is shown as white: daylight, the light of the luminaires, or any colour temperature.
class WhiteFields : public QWidget {
  Q_OBJECT

 public:
  explicit WhiteFields(QWidget* parent = nullptr);
  void showView(const scene::View& view);

 Q_SIGNALS:
  /// Daylight (0) or a temperature at all, kelvin.
  void chosen(double kelvin);
  /// Another temperature, kelvin: one of many on the way.
  void edited(double kelvin);
  /// The white of the luminaires is wanted.
  void luminairesRequested();

 private:
  QComboBox* choice_;
  QuantityBox* kelvin_;
};

}  // namespace soffit::ui
