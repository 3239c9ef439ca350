// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace soffit::ui {

/// What is shown before a project is open: the samples with their pictures, and the files that
/// were open last.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);
  void refresh();

 Q_SIGNALS:
  void chosen(const QString& path);
  void openRequested();
  void newRequested();
  void importRequested();

 private:
  QWidget* makeSamples();
  QWidget* makeRecent();

  QVBoxLayout* column_;
  QWidget* content_ = nullptr;
};

}  // namespace soffit::ui
