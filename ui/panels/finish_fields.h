// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;

namespace soffit::ui {

class QuantityBox;

/// What pictures are finished with: the settings of views that adapt to them, and bloom.
class FinishFields : public QWidget {
  Q_OBJECT

 public:
  using Change = std::function<void(scene::View&)>;

  explicit FinishFields(QWidget* parent = nullptr);
  /// Shows a project's settings; those of a tone operator only where its view has them.
  void showView(const scene::View& view);

 Q_SIGNALS:
  /// text: of the undo step. Changes with the same merge_key are one step.
  void edited(const QString& text, const soffit::ui::FinishFields::Change& change, int merge_key);

 private:
  QFormLayout* form_;
  QDoubleSpinBox* key_;
  QDoubleSpinBox* white_;
  QCheckBox* bloom_;
  QuantityBox* threshold_;
  QuantityBox* strength_;
};

}  // namespace soffit::ui
