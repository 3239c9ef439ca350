// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/mixing.h"
#include "ui/widgets/quantity_box.h"

#include <QWidget>

class QPushButton;
class QSlider;
class QToolButton;

namespace soffit::ui {

/// One group of the mixer: fader, switch, solo, colour. Says what the user did; shows what it is
/// given.
class GroupStrip : public QWidget {
  Q_OBJECT

 public:
  explicit GroupStrip(QWidget* parent = nullptr);
  void showGroup(const GroupState& group, bool solo);
  [[nodiscard]] const QString& group() const { return group_; }

 Q_SIGNALS:
  void levelMoved(const QString& group, double level);
  void switched(const QString& group, bool on);
  void soloed(const QString& group, bool solo);
  void cctChosen(const QString& group, double cct_k);
  void colourWanted(const QString& group);
  void selectWanted(const QString& group);

 private:
  QString group_;
  QPushButton* name_;
  QToolButton* on_;
  QToolButton* solo_;
  QSlider* fader_;
  QuantityBox* level_;
  QuantityBox* cct_;
  QToolButton* colour_;
};

}  // namespace soffit::ui
