// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/key_bindings.h"

#include <QDialog>

class QComboBox;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace soffit::ui {

/// Cheat-sheet and editor: what the mouse does, and every command with its keys, which can be
/// changed at once. Stays open beside the work.
class KeysDialog : public QDialog {
  Q_OBJECT

 public:
  KeysDialog(KeyBindings& bindings, QWidget* parent);

 private:
  QWidget* makeMouse();
  QWidget* makeKeys();
  void fill();
  void filter(const QString& text);
  void showCurrent();
  void assign();
  [[nodiscard]] QString current() const;

  KeyBindings& bindings_;
  QLineEdit* search_;
  QTreeWidget* list_;
  QComboBox* preset_;
  QKeySequenceEdit* edit_;
  QPushButton* assign_;
  QPushButton* reset_;
  QLabel* conflict_;
};

}  // namespace soffit::ui
