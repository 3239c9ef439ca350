// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/commands.h"

#include <QDialog>

class QLineEdit;
class QTreeWidget;

namespace soffit::ui {

/// Every command by a few letters of its name: type, choose with the arrows, Enter. Commands that
/// were run from here lately stand first.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  CommandPalette(std::vector<Command> commands, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill(const QString& text);
  void run();

  std::vector<Command> commands_;  ///< the latest first
  std::vector<Command> shown_;
  QLineEdit* line_;
  QTreeWidget* list_;
};

}  // namespace soffit::ui
