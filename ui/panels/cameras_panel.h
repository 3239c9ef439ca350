// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QListWidget;
class QToolButton;

namespace soffit::ui {

/// The project's saved cameras: to look from, to name, to order, to bring up to date.
class CamerasPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CamerasPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  /// The one next to what was chosen last, round the end; for keys.
  void chooseNext(int step);

 Q_SIGNALS:
  /// The view is to look from there.
  void cameraChosen(const QString& name);
  /// What the view shows is to be saved: under a new name, or in place of a camera.
  void saveRequested();
  void updateRequested(const QString& name);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void enableButtons();
  void moveRow(int step);
  void removeCurrent();
  [[nodiscard]] QString current() const;

  Document* document_ = nullptr;
  QListWidget* list_;
  QToolButton* update_;
  QToolButton* up_;
  QToolButton* down_;
  QToolButton* remove_;
  bool filling_ = false;
};

}  // namespace soffit::ui
