// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/engine.h"
#include "core/scene/scene.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace soffit::ui {

/// Every single setting of a quality: the method of direct light, and all numbers with their
/// ranges. What differs from the preset is marked, and alone becomes part of the project.
class AdvancedQuality : public QDialog {
  Q_OBJECT

 public:
  explicit AdvancedQuality(const scene::Quality& quality, QWidget* parent = nullptr);

  [[nodiscard]] scene::Quality quality() const;

 private:
  struct Row {
    relight::SettingInfo info;  ///< value: the preset's
    QDoubleSpinBox* box = nullptr;
    QLabel* label = nullptr;
  };
  void mark();
  void reset();

  scene::Quality preset_;  ///< without single settings
  QComboBox* direct_;
  QFormLayout* form_;
  std::vector<Row> rows_;
};

}  // namespace soffit::ui
