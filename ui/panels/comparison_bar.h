// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/comparison_mode.h"
#include "ui/widgets/quantity_box.h"

#include <QFrame>
#include <QStringList>

class QButtonGroup;
class QComboBox;
class QLabel;

namespace soffit::ui {

/// The strip over the view while two layouts are compared: which, how, and the way out.
class ComparisonBar : public QFrame {
  Q_OBJECT

 public:
  explicit ComparisonBar(QWidget* parent = nullptr);

  void setMode(ComparisonMode mode);
  /// shown: the layout in the view; others: what it can be compared with; other: the one it is.
  /// Empty names are the base.
  void setLayouts(const QString& shown, const QStringList& others, const QString& other);
  /// Ends of the scale of differences, lux.
  void setRange(double lux);

 Q_SIGNALS:
  void modeChosen(ComparisonMode mode);
  void otherChosen(const QString& layout);
  void rangeChosen(double lux);
  void swapRequested();
  void closeRequested();

 private:
  QLabel* first_;
  QComboBox* second_;
  QButtonGroup* modes_;
  QWidget* range_fields_;
  QuantityBox* range_;
};

}  // namespace soffit::ui
