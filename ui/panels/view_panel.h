// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/look.h"
#include "ui/widgets/lux_scale_fields.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QSlider;

namespace soffit::ui {

class FinishFields;
class WhiteFields;

/// What is shown of the light on work planes.
struct PlaneLook {
  bool values = false;         ///< a number at each point
  std::vector<double> levels;  ///< of isolux lines, lux; empty: none

  [[nodiscard]] bool any() const { return values || !levels.empty(); }
};

/// How light is looked at: exposure and view transform; false colours, isolux lines and values of
/// work planes on one scale.
class ViewPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ViewPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);

  [[nodiscard]] Look look() const;
  [[nodiscard]] bool falseColor() const;
  void setFalseColor(bool on);
  [[nodiscard]] PlaneLook planeLook() const;
  [[nodiscard]] color::LuxScale scale() const { return scale_->scale(); }
  void setIsolines(bool on);
  void setValues(bool on);
  /// A range of the scale that the user has not chosen: used until one is.
  void suggestRange(const color::FalseColorRange& range);
  void stepExposure(double stops);

 Q_SIGNALS:
  void lookChanged();
  void falseColorChanged(bool on);
  void isolinesChanged(bool on);
  void valuesChanged(bool on);
  void autoExposureRequested();

 private:
  void refresh();
  void editView(const QString& text, const std::function<void(scene::View&)>& change,
                int merge_key = -1);
  void makeTransformFields();
  void makeLightFields();
  void showTransform(const scene::View& view);
  void showScale();

  Document* document_ = nullptr;
  QSlider* exposure_slider_;
  QuantityBox* exposure_;
  WhiteFields* white_;
  QComboBox* view_;
  QComboBox* look_;
  QComboBox* display_;
  QString views_of_;  ///< the display whose views are listed
  FinishFields* finish_;
  QCheckBox* false_color_;
  QCheckBox* isolines_;
  QComboBox* lines_on_;
  QCheckBox* values_;
  LuxScaleFields* scale_;
};

}  // namespace soffit::ui
