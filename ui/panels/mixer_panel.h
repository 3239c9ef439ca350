// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/group_strip.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace soffit::ui {

/// The light mixer: scenes along the top, a strip for each group of luminaires below.
class MixerPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MixerPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  [[nodiscard]] const std::vector<GroupStrip*>& strips() const { return strips_; }

  /// Scene `number` from 0: recalled when it is there.
  void recall(std::size_t number);
  void store(std::size_t number);

 private:
  void refresh();
  void refreshScenes();
  GroupStrip* addStrip();
  void sceneMenu(std::size_t number, const QPoint& at);
  void chooseColour(const QString& group);

  Document* document_ = nullptr;
  QVBoxLayout* rows_;
  QHBoxLayout* scenes_;
  QLabel* empty_;
  QToolButton* add_;
  std::vector<QToolButton*> scene_buttons_;
  std::vector<GroupStrip*> strips_;
};

}  // namespace soffit::ui
