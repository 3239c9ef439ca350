// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;

namespace soffit::ui {

/// Shape and sizes of a luminaire. Polygons and meshes are shown by their name; their sizes are
/// changed in the view.
class ShapeFields : public QWidget {
  Q_OBJECT

 public:
  explicit ShapeFields(QWidget* parent = nullptr);
  /// Nothing: several shapes.
  void showShape(const light::Shape* shape);

 Q_SIGNALS:
  void edited(const light::Shape& shape);

 private:
  void showSizes();
  void take(std::size_t size, double value);

  light::Shape shape_;
  QComboBox* kind_;
  std::array<QLabel*, 2> labels_{};
  std::array<QuantityBox*, 2> sizes_{};
};

}  // namespace soffit::ui
