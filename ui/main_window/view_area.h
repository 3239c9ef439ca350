// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_input.h"
#include "ui/widgets/legend.h"

#include <QLabel>
#include <QWidget>

namespace soffit::ui {

/// The view with what lies over it: the legend of false colours, and a word while there is no light
/// yet.
class ViewArea : public QWidget {
  Q_OBJECT

 public:
  explicit ViewArea(QWidget* parent = nullptr);

  [[nodiscard]] SceneView& view() { return *view_; }
  [[nodiscard]] ViewInput& input() { return *input_; }
  /// Errors: SceneView::setLook()'s.
  Result<void> setLook(const Look& look);
  /// Empty: none.
  void setNotice(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  SceneView* view_;
  ViewInput* input_;
  Legend* legend_;
  QLabel* notice_;
};

}  // namespace soffit::ui
