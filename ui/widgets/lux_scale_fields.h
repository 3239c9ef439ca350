// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/lux_scale.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace soffit::ui {

/// The fields of the scale of illuminance: ends, logarithmic or not, steps, colours, and the levels
/// of isolux lines. The range follows the light until the user sets it; colours and the series of
/// levels are remembered in the user's settings.
class LuxScaleFields : public QWidget {
  Q_OBJECT

 public:
  explicit LuxScaleFields(QWidget* parent = nullptr);

  /// In the unit that is shown (units.h).
  [[nodiscard]] color::LuxScale scale() const;
  [[nodiscard]] std::vector<double> levels() const;
  /// A range that the user has not chosen: used until one is.
  void suggestRange(const color::FalseColorRange& range);
  /// The next range comes from the light again.
  void forgetRange();

 Q_SIGNALS:
  void changed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectFields();
  void takeRange();
  void takeLevels();
  void showLevels();
  void refresh();

  color::LuxScale scale_;
  color::LevelSeries series_ = color::LevelSeries::round;
  std::vector<double> chosen_;  ///< lux
  bool range_chosen_ = false;
  QuantityBox* min_;
  QuantityBox* max_;
  QCheckBox* logarithmic_;
  QComboBox* map_;
  QSpinBox* steps_;
  QComboBox* levels_;
  QLineEdit* chosen_levels_;
};

/// Illuminances as people list them, "300, 500 750" or "28 fc; 46.5 fc", in lux; bare numbers are
/// in the unit shown. What is no illuminance is left out.
std::vector<double> parseLevels(const QString& text);

}  // namespace soffit::ui
