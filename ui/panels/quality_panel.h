// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/light_frame.h"
#include "ui/viewport/sky_evaluation.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace soffit::ui {

/// How carefully the light is computed, what that costs now, and what this project does without.
class QualityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit QualityPanel(QWidget* parent = nullptr);
  /// Null: nothing is open.
  void setDocument(Document* document);
  /// The newest light: its times (of the last move) and the size of its transport.
  void showFrame(const LightFrame& frame);
  /// How the last picture's light was added up, while a slider of the surroundings is held.
  void showSky(const SkyEvaluation::Figures& figures);

 private:
  void showProject();
  void choose(const QString& preset);
  void setQuality(const scene::Quality& quality);
  void openAdvanced();
  QTreeWidgetItem* row(QTreeWidgetItem* section, const QString& what, const QString& hint);

  QPointer<Document> document_;
  QComboBox* preset_;
  QLabel* own_;  ///< single settings of the project
  QTreeWidget* figures_;
  QTreeWidgetItem* update_;
  QTreeWidgetItem* visibility_;
  QTreeWidgetItem* transport_;
  QTreeWidgetItem* needed_;
  QTreeWidgetItem* skipped_;
};

}  // namespace soffit::ui
