// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/help_pages.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QToolButton;

namespace soffit::ui {

/// The help: contents, a search through all pages, and the page with its hits marked. Stays open
/// beside the work.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  /// folder: helpFolder(), or another one with pages.
  HelpWindow(const QString& folder, QWidget* parent);

  /// Shows a page by its file, "materials.md"; one that is not there: the first.
  void showPage(const QString& file);
  /// Lists the pages that hold these words and shows the first of them.
  void search(const QString& text);
  [[nodiscard]] const QString& currentPage() const { return page_; }
  /// Places that are marked in the page that is shown.
  [[nodiscard]] int markedCount() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeContents();
  QWidget* makeReader();
  void fill();
  void dress();
  void mark();
  void goToHit(int by);

  QString folder_;
  std::vector<HelpPage> pages_;
  QString page_;  ///< the file that is shown
  QLineEdit* search_;
  QListWidget* list_;
  QTextBrowser* text_;
  QLabel* state_;
  QToolButton* previous_;
  QToolButton* next_;
};

}  // namespace soffit::ui
