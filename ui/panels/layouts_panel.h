// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QListWidget;
class QToolButton;

namespace soffit::ui {

/// The layouts of the project: which is shown, and a copy of it to try something else.
class LayoutsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayoutsPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);

  /// A new layout that begins as the one that is shown, and is shown from then on.
  void duplicateShown();

 private:
  void refresh();

  Document* document_ = nullptr;
  QListWidget* list_;
  QToolButton* duplicate_;
  bool following_ = false;
};

}  // namespace soffit::ui
