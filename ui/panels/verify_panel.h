// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/verification.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace soffit::ui {

/// How far the light that is shown is from the path tracer's: asks for it, shows the figures, and
/// says whether they still hold.
class VerifyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit VerifyPanel(QWidget* parent = nullptr);
  /// Null: nothing is open.
  void setVerification(Verification* verification, Document* document = nullptr);
  /// Begins with what is chosen here.
  void start();
  [[nodiscard]] bool mapWanted() const;
  void setMapWanted(bool wanted);
  /// The figures as tab-separated text.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void mapWantedChanged(bool wanted);

 private:
  void showState();
  void showFigures();
  void addRows(QTreeWidgetItem* parent, const design::LightErrors& errors);
  QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const QString& name,
                          const design::ErrorFigures& figures);

  QPointer<Verification> verification_;
  QPointer<Document> document_;
  VerifiedLightPtr shown_;
  QComboBox* error_;
  QComboBox* limit_;
  QCheckBox* alone_;
  QToolButton* run_;
  QCheckBox* map_;
  QToolButton* copy_;
  QLabel* state_;
  QTreeWidget* figures_;
};

}  // namespace soffit::ui
