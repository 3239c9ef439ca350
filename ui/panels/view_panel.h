// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/look.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QSlider;

namespace soffit::ui {

/// How light is looked at: exposure and view transform, false colours with their range.
class ViewPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ViewPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);

  [[nodiscard]] Look look() const;
  [[nodiscard]] bool falseColor() const;
  void setFalseColor(bool on);
  /// A range for false colours that the user has not chosen: used until one is.
  void suggestRange(const color::FalseColorRange& range);
  void stepExposure(double stops);

 Q_SIGNALS:
  void lookChanged();
  void falseColorChanged(bool on);
  void autoExposureRequested();

 private:
  void refresh();
  void editView(const QString& text, const std::function<void(scene::View&)>& change,
                int merge_key = -1);
  void takeRange();

  Document* document_ = nullptr;
  QSlider* exposure_slider_;
  QuantityBox* exposure_;
  QComboBox* view_;
  QCheckBox* false_color_;
  QuantityBox* range_min_;
  QuantityBox* range_max_;
  QCheckBox* logarithmic_;
  QWidget* range_fields_;
  color::FalseColorRange range_{0.0, 1000.0, false};
  bool range_chosen_ = false;
};

}  // namespace soffit::ui
