// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/recovery.h"

#include <QDialog>

class QListWidget;

namespace soffit::ui {

/// Offers the versions that an earlier run left. Accepted: chosen() is to be opened; rejected: they
/// stay for the next start.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  explicit RecoveryDialog(const QList<Recovery>& recoveries, QWidget* parent = nullptr);
  [[nodiscard]] Recovery chosen() const;

 private:
  void discardChosen();

  QList<Recovery> recoveries_;
  QListWidget* list_;
};

}  // namespace soffit::ui
