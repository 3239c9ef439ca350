// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/view_bar.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_input.h"

#include <QObject>
#include <QRect>

namespace soffit::ui {

/// One view of the centre with its bar: which of the standard views it shows.
class ViewPane : public QObject {
  Q_OBJECT

 public:
  /// View and bar become parts of `area`.
  explicit ViewPane(QWidget& area);

  [[nodiscard]] SceneView& view() { return *view_; }
  [[nodiscard]] ViewInput& input() { return *input_; }
  [[nodiscard]] ViewBar& bar() { return *bar_; }
  [[nodiscard]] StandardView standardView() const;
  /// The layout that is shown; nothing: the one that is edited. What is in the picture is the
  /// grid's to set.
  [[nodiscard]] const std::optional<QString>& layout() const { return layout_; }
  void setLayout(const std::optional<QString>& layout);
  /// The perspective that was shown last.
  [[nodiscard]] const ViewCamera& perspective() const { return perspective_; }
  void setPerspective(const ViewCamera& camera) { perspective_ = camera; }
  /// The perspective comes back as it was left; the others show all of the building. A plan is of
  /// the storey that the perspective stands in.
  void show(StandardView standard);
  /// above: px at the upper edge that the bar leaves free.
  void setGeometry(const QRect& rect, int above = 0);
  void setVisible(bool visible);

 Q_SIGNALS:
  void layoutChanged();

 private:
  void onCamera();
  [[nodiscard]] double floor() const;

  SceneView* view_;
  ViewInput* input_;
  ViewBar* bar_;
  ViewCamera perspective_;
  std::optional<QString> layout_;
};

}  // namespace soffit::ui
