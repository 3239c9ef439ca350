// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/standard_view.h"
#include "ui/widgets/quantity_box.h"

#include <QFrame>
#include <QStringList>

#include <optional>

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
  /// The layouts that the view can show in place of the one that is edited; an empty name is the
  /// base. Without any there is no such choice.
  void setLayouts(const QStringList& names);
  /// Which is shown; nothing: the one that is edited.
  void setLayout(const std::optional<QString>& layout);

 Q_SIGNALS:
  void viewChosen(StandardView view);
  void cameraChosen(const QString& name);
  void cutChosen(double metres);
  void layoutChosen(const std::optional<QString>& layout);

 private:
  void fillMenu();
  void showText();

  QToolButton* view_;
  QLabel* cut_label_;
  QuantityBox* cut_;
  QStringList cameras_;
  QStringList layouts_;
  std::optional<QString> layout_;
  StandardView shown_ = StandardView::perspective;
};

}  // namespace soffit::ui
