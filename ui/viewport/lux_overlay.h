// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/lux_marks.h"

#include <QTimer>
#include <QWidget>

namespace soffit::ui {

class SceneView;

/// Light in numbers and lines over a view: what LuxMarks say, and the values of the isolux lines
/// that the view's picture holds, where they have room. Those follow when the picture is at rest.
class LuxOverlay : public QWidget {
  Q_OBJECT

 public:
  explicit LuxOverlay(SceneView& view);

  void setMarks(LuxMarks marks);
  [[nodiscard]] const LuxMarks& marks() const { return marks_; }
  /// The look of the view, or its light, is another.
  void refresh();
  /// What is painted now.
  [[nodiscard]] const SeenMarks& seen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void labelLines();
  [[nodiscard]] Sight sight(const ViewCamera& camera, const dvec2& size) const;

  SceneView& view_;
  LuxMarks marks_;
  SeenMarks seen_;
  bool stale_ = true;
  std::vector<render::LineLabel> labels_;
  double label_scale_ = 1.0;  ///< logical pixels per pixel of the picture they were found in
  QTimer rest_;
};

}  // namespace soffit::ui
