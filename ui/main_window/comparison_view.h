// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/comparison_bar.h"
#include "ui/viewport/comparison_mode.h"
#include "ui/viewport/scene_view.h"

#include <QLabel>
#include <QTimer>
#include <QWidget>

namespace soffit::ui {

/// The second picture of a comparison, laid over or beside the view, with what belongs to it: the
/// slider, the names, the bar. Mouse and keys in it do what they do at the same place of the view.
class ComparisonView : public QObject {
  Q_OBJECT

 public:
  /// Both become parts of `area`, above `first`.
  ComparisonView(SceneView& first, QWidget& area);

  void setMode(ComparisonMode mode);
  [[nodiscard]] ComparisonMode mode() const { return mode_; }
  /// The second view; there from the first comparison on.
  [[nodiscard]] SceneView& second();
  [[nodiscard]] ComparisonBar& bar() { return *bar_; }
  /// Which of the two a blink shows at present.
  [[nodiscard]] bool showsSecond() const;
  /// Where the slider of a split is, 0..1 from the left.
  [[nodiscard]] double split() const { return split_; }
  void setSplit(double place);
  void setNames(const QString& first, const QString& second);
  /// How far down from the area's upper edge its bar reaches, px; 0 without one.
  [[nodiscard]] int barEnd() const;
  /// Lays everything out in the area; returns what is left to the view.
  QRect layOut(const QRect& area);

 Q_SIGNALS:
  /// The view should be laid out again.
  void layoutChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void blink();
  void showNames();
  bool forward(QEvent* event);

  SceneView& first_;
  QWidget& area_;
  ComparisonMode mode_ = ComparisonMode::off;
  double split_ = 0.5;
  bool blink_second_ = false;
  QWidget* clip_;  ///< the part of the area that the second picture has
  SceneView* second_ = nullptr;
  QWidget* slider_;
  QLabel* first_name_;
  QLabel* second_name_;
  ComparisonBar* bar_;
  QTimer blink_;
  QString names_[2];
};

}  // namespace soffit::ui
