// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/panels/shape_fields.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

#include <array>
#include <functional>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSlider;

namespace soffit::ui {

/// The properties of the luminaires that are selected. Values that differ among several show as
/// "mixed" until they are given one value. Each change is an undo step; a slider's way is one.
class LuminairePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LuminairePanel(QWidget* parent = nullptr);
  void setDocument(Document* document);

 private:
  using Change = std::function<void(light::Luminaire&)>;
  void refresh();
  void edit(const QString& text, const Change& change, int merge_key = -1);
  QuantityBox* addBox(Dimension dimension, double least, double most, double step, int decimals,
                      const QString& hint);
  QWidget* addTriple(std::array<QuantityBox*, 3>& boxes, Dimension dimension, double step,
                     int decimals, const QString& hint);
  void connectEdits();
  [[nodiscard]] std::vector<const light::Luminaire*> selected() const;

  Document* document_ = nullptr;
  QLabel* title_;
  QLabel* kind_;
  QWidget* fields_;
  QCheckBox* on_;
  QSlider* dimming_slider_;
  QuantityBox* dimming_;
  QuantityBox* flux_;
  QuantityBox* cct_;
  std::array<QuantityBox*, 3> position_{};
  std::array<QuantityBox*, 3> rotation_{};
  ShapeFields* shape_;
  QLineEdit* group_;
  QCheckBox* casts_shadow_;
};

}  // namespace soffit::ui
