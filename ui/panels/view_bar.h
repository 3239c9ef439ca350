// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/standard_view.h"
#include "ui/widgets/quantity_box.h"

#include <QFrame>
#include <QStringList>

class QLabel;
class QToolButton;

namespace soffit::ui {

/// The bar in the corner of a view: what is seen, another view to choose, and where a flat view is
/// cut.
class ViewBar : public QFrame {
  Q_OBJECT

 public:
  explicit ViewBar(QWidget* parent = nullptr);

  /// What is shown. cut: place on the axis that one looks along, m; nothing: there is none.
  void setView(StandardView view, std::optional<double> cut);
  /// Those to choose from beside the standard views.
  void setCameras(const QStringList& names);

 Q_SIGNALS:
  void viewChosen(StandardView view);
  void cameraChosen(const QString& name);
  void cutChosen(double metres);

 private:
  void fillMenu();

  QToolButton* view_;
  QLabel* cut_label_;
  QuantityBox* cut_;
  QStringList cameras_;
};

}  // namespace soffit::ui
