// SPDX-License-Identifier: MIT
#include "ui/panels/layouts_panel.h"

#include "core/scene/layout_edits.h"
#include "ui/document/text.h"

#include <QAbstractItemModel>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr QSize kThumbnail(72, 45);

QToolButton* button(QHBoxLayout& row, const QString& text, const QString& hint) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(hint);
  button->setAccessibleName(hint);
  row.addWidget(button);
  return button;
}

/// The same in the row that is chosen: a picture is not to be tinted.
QIcon iconOf(const QPixmap& picture) {
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected);
  return icon;
}

QString layoutOf(const QListWidgetItem& item) {
  return item.data(Qt::UserRole).toString();
}

}  // namespace

LayoutsPanel::LayoutsPanel(QWidget* parent) : QWidget(parent), list_(new QListWidget) {
  list_->setAccessibleName(tr("Layouts"));
  list_->setIconSize(kThumbnail);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setDefaultDropAction(Qt::MoveAction);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setUniformItemSizes(true);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  duplicate_ = button(*row, tr("Duplicate"), tr("A copy of this layout to change"));
  delete_ = button(*row, tr("Delete"), tr("Delete this layout"));
  up_ = button(*row, QStringLiteral("\u2191"), tr("Move up"));
  down_ = button(*row, QStringLiteral("\u2193"), tr("Move down"));
  row->addStretch(1);
  compare_ = button(*row, tr("Compare"), tr("Compare the layout shown with another"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addWidget(list_, 1);
  layout->addLayout(row);

  connect(duplicate_, &QToolButton::clicked, this, &LayoutsPanel::duplicateShown);
  connect(delete_, &QToolButton::clicked, this, &LayoutsPanel::deleteShown);
  connect(up_, &QToolButton::clicked, this, [this] { moveShown(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { moveShown(1); });
  connect(compare_, &QToolButton::clicked, this,
          [this] { Q_EMIT comparisonRequested(ComparisonMode::split); });
  connect(list_, &QListWidget::customContextMenuRequested, this, &LayoutsPanel::showMenu);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int at) {
    if (following_ || document_ == nullptr || at < 0) return;
    document_->setLayout(layoutOf(*list_->item(at)));
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!following_ && document_ != nullptr) rename(*item);
  });
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this,
          [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
            if (!following_) takeOrder(from, to > from ? to - 1 : to);
          });
  updateButtons();
}

QSize LayoutsPanel::thumbnailSize() const {
  return (QSizeF(kThumbnail) * devicePixelRatioF()).toSize();
}

void LayoutsPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  thumbnails_.clear();
  list_->clear();
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &LayoutsPanel::refresh);
    connect(document_, &Document::layoutChanged, this, &LayoutsPanel::refresh);
  }
  refresh();
}

QStringList LayoutsPanel::names() const {
  QStringList names;
  if (document_ == nullptr) return names;
  names.append(QString());
  for (const scene::Layout& layout : document_->scene()->layouts) names.append(toQt(layout.name));
  return names;
}

void LayoutsPanel::refresh() {
  following_ = true;
  const QStringList wanted = names();
  QStringList listed;
  for (int i = 0; i < list_->count(); ++i) listed.append(layoutOf(*list_->item(i)));
  if (listed != wanted) {
    list_->clear();
    QPixmap blank(thumbnailSize());
    blank.fill(Qt::transparent);
    for (const QString& name : wanted) {
      auto* item = new QListWidgetItem(name.isEmpty() ? tr("Base") : name, list_);
      item->setData(Qt::UserRole, name);
      item->setIcon(iconOf(thumbnails_.value(name, blank)));
      item->setToolTip(name.isEmpty() ? tr("What all layouts have in common")
                                      : tr("F2: rename; drag: another place"));
      item->setFlags(name.isEmpty() ? Qt::ItemIsSelectable | Qt::ItemIsEnabled
                                    : Qt::ItemIsSelectable | Qt::ItemIsEnabled |
                                          Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
    }
  }
  if (document_ != nullptr) {
    list_->setCurrentRow(static_cast<int>(wanted.indexOf(document_->layout())));
  }
  following_ = false;
  updateButtons();
}

void LayoutsPanel::updateButtons() {
  const QStringList all = names();
  const auto at = document_ == nullptr ? -1 : all.indexOf(document_->layout());
  duplicate_->setEnabled(document_ != nullptr);
  delete_->setEnabled(at > 0);
  up_->setEnabled(at > 1);
  down_->setEnabled(at > 0 && at + 1 < all.size());
  compare_->setEnabled(all.size() > 1);
}

void LayoutsPanel::setThumbnail(const QString& layout, const QImage& picture) {
  if (picture.isNull()) return;
  QPixmap pixmap = QPixmap::fromImage(picture);
  thumbnails_[layout] = pixmap;
  following_ = true;
  for (int i = 0; i < list_->count(); ++i) {
    if (layoutOf(*list_->item(i)) == layout) list_->item(i)->setIcon(iconOf(pixmap));
  }
  following_ = false;
}

void LayoutsPanel::duplicateShown() {
  if (document_ == nullptr) return;
  const QString source = document_->layout();
  const std::string name =
      scene::freeLayoutName(*document_->scene(), toStd(source.isEmpty() ? tr("Layout") : source));
  auto next = scene::withLayout(*document_->scene(), name, toStd(source));
  if (!next) return;
  thumbnails_[toQt(name)] = thumbnails_.value(source);
  document_->editLayouts(tr("Duplicate layout"), std::move(*next), toQt(name),
                         std::pair(toQt(name), source));
}

void LayoutsPanel::deleteShown() {
  if (document_ == nullptr || document_->layout().isEmpty()) return;
  const QStringList all = names();
  const auto at = all.indexOf(document_->layout());
  // The one below it, else the one above.
  const QString next_shown = at + 1 < all.size() ? all[at + 1] : all[at - 1];
  auto next = scene::withoutLayout(*document_->scene(), toStd(document_->layout()));
  if (next) document_->editLayouts(tr("Delete layout"), std::move(*next), next_shown);
}

void LayoutsPanel::renameShown() {
  if (list_->currentRow() > 0) list_->editItem(list_->currentItem());
}

void LayoutsPanel::rename(const QListWidgetItem& item) {
  const QString from = layoutOf(item);
  const QString to = item.text().trimmed();
  auto next = scene::withLayoutRenamed(*document_->scene(), toStd(from), toStd(to));
  if (next && from != to) {
    thumbnails_[to] = thumbnails_.value(from);
    const QString shown = document_->layout() == from ? to : document_->layout();
    document_->editLayouts(tr("Rename layout"), std::move(*next), shown, std::pair(to, from));
    return;
  }
  // Empty or taken: the old name comes back.
  const QSignalBlocker quiet(list_);
  list_->item(list_->row(&item))->setText(from);
}

void LayoutsPanel::takeOrder(int from, int to) {
  const auto& layouts = document_->scene()->layouts;
  const auto moved = static_cast<std::size_t>(from - 1);
  // The base keeps the first row.
  auto next = scene::withLayoutAt(*document_->scene(), layouts[moved].name,
                                  static_cast<std::size_t>(std::max(to, 1) - 1));
  if (next) document_->editLayouts(tr("Move layout"), std::move(*next), document_->layout());
  refresh();
}

void LayoutsPanel::moveShown(int by) {
  if (document_ == nullptr) return;
  const auto at = names().indexOf(document_->layout());
  if (at < 1 || at + by < 1 || at + by >= names().size()) return;
  auto next = scene::withLayoutAt(*document_->scene(), toStd(document_->layout()),
                                  static_cast<std::size_t>(at + by - 1));
  if (next) document_->editLayouts(tr("Move layout"), std::move(*next), document_->layout());
}

void LayoutsPanel::showMenu(const QPoint& at) {
  if (document_ == nullptr || list_->itemAt(at) == nullptr) return;
  QMenu menu;
  menu.addAction(tr("Duplicate"), this, &LayoutsPanel::duplicateShown);
  menu.addAction(tr("Rename"), this, &LayoutsPanel::renameShown)
      ->setEnabled(list_->currentRow() > 0);
  menu.addAction(tr("Delete"), this, &LayoutsPanel::deleteShown)
      ->setEnabled(list_->currentRow() > 0);
  menu.exec(list_->viewport()->mapToGlobal(at));
}

}  // namespace soffit::ui
