// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QPlainTextEdit;

namespace soffit::ui {

/// What the program has to say, line by line, to read and to copy.
class LogPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LogPanel(QWidget* parent = nullptr);
  void addLine(const QString& text);
  void addWarning(const QString& text);

 private:
  QPlainTextEdit* text_;
};

}  // namespace soffit::ui
