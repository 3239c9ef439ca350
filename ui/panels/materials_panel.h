// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QLabel;
class QListWidget;
class QSlider;
class QToolButton;

namespace soffit::ui {

/// The surfaces: which material, how much it reflects, its colour and gloss. Light follows without
/// a new precomputation. A click on a surface in the view chooses its material.
class MaterialsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MaterialsPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  void choose(const QString& material);
  [[nodiscard]] QString chosen() const;

 private:
  void refresh();
  void showChosen();
  void chooseColour();
  [[nodiscard]] const scene::Material* material() const;
  void edit(const QString& text,
            const std::function<scene::Material(const scene::Material&)>& change, int merge_key);
  void connectEdits();

  Document* document_ = nullptr;
  std::vector<scene::Material> known_;  ///< as the list shows them
  std::vector<double> rho_;
  QListWidget* list_;
  QWidget* fields_;
  QSlider* rho_slider_;
  QuantityBox* rho_box_;
  QLabel* warning_;
  QToolButton* colour_;
  QuantityBox* specular_;
  QSlider* roughness_slider_;
  QuantityBox* roughness_;
  QCheckBox* glass_;
  QuantityBox* transmittance_;
  QLabel* note_;
  bool following_ = false;
};

}  // namespace soffit::ui
