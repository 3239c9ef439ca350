// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/comparison_mode.h"

#include <QHash>
#include <QPixmap>
#include <QWidget>

class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace soffit::ui {

/// The layouts of the project with their pictures: which is shown, copies to try something else,
/// their names and their order. Each change is one undo step.
class LayoutsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayoutsPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  /// The picture of a layout; empty name: the base.
  void setThumbnail(const QString& layout, const QImage& picture);
  /// Physical pixels of a thumbnail.
  [[nodiscard]] QSize thumbnailSize() const;

  /// A new layout that begins as the one that is shown, and is shown from then on.
  void duplicateShown();
  /// Removes the layout that is shown; its neighbour is shown then.
  void deleteShown();
  /// Lets the user type another name for the layout that is shown.
  void renameShown();
  /// Moves the layout that is shown up (-1) or down (1) in the list.
  void moveShown(int by);

 Q_SIGNALS:
  void comparisonRequested(ComparisonMode mode);

 private:
  void refresh();
  void rename(const QListWidgetItem& item);
  void takeOrder(int from, int to);
  void showMenu(const QPoint& at);
  void updateButtons();
  [[nodiscard]] QStringList names() const;

  Document* document_ = nullptr;
  QListWidget* list_;
  QToolButton* duplicate_;
  QToolButton* delete_;
  QToolButton* up_;
  QToolButton* down_;
  QToolButton* compare_;
  QHash<QString, QPixmap> thumbnails_;
  bool following_ = false;
};

}  // namespace soffit::ui
