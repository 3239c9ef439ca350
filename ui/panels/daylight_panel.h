// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/document/environment_edits.h"
#include "ui/jobs/background.h"
#include "ui/widgets/quantity_box.h"
#include "ui/widgets/slider_box.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace soffit::ui {

/// What shines in from outside: none, a standard sky with its sun, a light probe, or the light
/// without a photograph. Each change is one undo step; while a slider is held, light follows
/// without rays.
class DaylightPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DaylightPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  /// Takes a picture as what shines in, as soon as it is read.
  void usePicture(const QString& path);

 Q_SIGNALS:
  /// A slider is being moved, or was let go.
  void held(bool in_hand);
  void failed(const QString& message);

 private:
  using Change = std::function<void(scene::Environment&, double)>;
  void makeSkyFields();
  void makePictureFields();
  void makeAnalyticFields();
  QDoubleSpinBox* number(QFormLayout* form, const QString& label, int key,
                         double scene::PatchLight::*field);
  void connectSlider(SliderBox* row, const QString& text, int key, const Change& change);
  void connectBox(QuantityBox* box, const QString& text, int key, const Change& change);
  void choose(OutsideKind kind);
  void askPicture();
  void takePicture(const QString& name, std::string bytes, scene::Image image);
  void edit(const QString& text, const std::function<void(scene::Environment&)>& change, int key);
  void refresh();
  [[nodiscard]] const std::optional<scene::Environment>& shown() const;

  Document* document_ = nullptr;
  scene::Sky sky_;  ///< as they were last, for coming back
  scene::Probe picture_;
  scene::PatchLight patches_;
  QComboBox* kind_;
  QWidget* sky_fields_;
  QComboBox* type_;
  SliderBox* azimuth_;
  SliderBox* altitude_;
  QuantityBox* horizontal_;
  QuantityBox* direct_;
  SliderBox* ground_;
  QWidget* picture_fields_;
  QPushButton* file_;
  QComboBox* layout_;
  SliderBox* rotation_;
  QDoubleSpinBox* scale_;
  QWidget* analytic_fields_;
  SliderBox* turn_;
  std::vector<std::pair<QDoubleSpinBox*, double scene::PatchLight::*>> numbers_;
  QLabel* note_;
  bool reading_ = false;
  Background background_;  ///< the last: its end waits for the work that uses the rest
};

}  // namespace soffit::ui
