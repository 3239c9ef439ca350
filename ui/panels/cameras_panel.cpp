// SPDX-License-Identifier: MIT
#include "ui/panels/cameras_panel.h"

#include "ui/document/camera_edits.h"
#include "ui/document/text.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace soffit::ui {
namespace {

/// The name as the document knows it, while the text is being edited.
constexpr int kName = Qt::UserRole;

}  // namespace

CamerasPanel::CamerasPanel(QWidget* parent) : QWidget(parent), list_(new QListWidget) {
  list_->setAccessibleName(tr("Saved cameras"));
  list_->setMinimumHeight(4 * fontMetrics().height());
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  list_->setToolTip(tr("A click looks from there; double-click or F2: another name; drag: order"));
  list_->installEventFilter(this);
  auto* save = new QPushButton(tr("Save view"));
  save->setToolTip(tr("Saves what the active view shows as a camera of the project"));
  const auto button = [&](const QString& text, const QString& hint) {
    auto* made = new QToolButton;
    made->setText(text);
    made->setToolTip(hint);
    made->setAccessibleName(hint);
    made->setAutoRaise(true);
    return made;
  };
  update_ = button(tr("Update"), tr("The selected camera takes what the active view shows"));
  up_ = button(QStringLiteral("\u2191"), tr("Further up"));
  down_ = button(QStringLiteral("\u2193"), tr("Further down"));
  remove_ = button(QStringLiteral("\u2715"), tr("Delete the selected camera"));
  auto* row = new QHBoxLayout;
  row->addWidget(save);
  row->addWidget(update_);
  row->addStretch(1);
  for (QToolButton* tool : {up_, down_, remove_}) row->addWidget(tool);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->addWidget(list_, 1);
  layout->addLayout(row);

  connect(save, &QPushButton::clicked, this, &CamerasPanel::saveRequested);
  connect(update_, &QToolButton::clicked, this, [this] { Q_EMIT updateRequested(current()); });
  connect(up_, &QToolButton::clicked, this, [this] { moveRow(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { moveRow(1); });
  connect(remove_, &QToolButton::clicked, this, &CamerasPanel::removeCurrent);
  connect(list_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
    Q_EMIT cameraChosen(item->data(kName).toString());
  });
  connect(list_, &QListWidget::currentRowChanged, this, &CamerasPanel::enableButtons);
  connect(list_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
    if (filling_ || document_ == nullptr) return;
    const QString name = item->data(kName).toString();
    // The list is filled anew either way, and not from within its own signal.
    QTimer::singleShot(0, this, [this, name, text = item->text()] {
      if (document_ != nullptr && !renameCamera(*document_, name, text)) refresh();
    });
  });
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this,
          [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
            if (filling_ || document_ == nullptr) return;
            const int now = to > from ? to - 1 : to;
            const QString name = list_->item(now)->data(kName).toString();
            QTimer::singleShot(0, this, [this, name, now] {
              if (document_ != nullptr) moveCamera(*document_, name, now);
            });
          });
  refresh();
}

void CamerasPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &CamerasPanel::refresh);
  }
  refresh();
}

QString CamerasPanel::current() const {
  const QListWidgetItem* item = list_->currentItem();
  return item == nullptr ? QString() : item->data(kName).toString();
}

void CamerasPanel::refresh() {
  setEnabled(document_ != nullptr);
  QStringList names;
  if (document_ != nullptr) {
    for (const scene::Camera& camera : document_->scene()->cameras) names.append(toQt(camera.name));
  }
  QStringList shown;
  for (int i = 0; i < list_->count(); ++i) shown.append(list_->item(i)->text());
  if (names != shown) {
    filling_ = true;
    // A renamed camera stays chosen where it is, a moved one by its name.
    const auto kept = names.indexOf(current());
    const int row = kept >= 0 ? static_cast<int>(kept) : list_->currentRow();
    list_->clear();
    for (const QString& name : names) {
      auto* item = new QListWidgetItem(name, list_);
      item->setData(kName, name);
      item->setFlags((item->flags() | Qt::ItemIsEditable) & ~Qt::ItemIsDropEnabled);
    }
    list_->setCurrentRow(std::min(row, list_->count() - 1));
    filling_ = false;
  }
  enableButtons();
}

void CamerasPanel::enableButtons() {
  const int row = list_->currentRow();
  update_->setEnabled(row >= 0);
  remove_->setEnabled(row >= 0);
  up_->setEnabled(row > 0);
  down_->setEnabled(row >= 0 && row + 1 < list_->count());
}

void CamerasPanel::moveRow(int step) {
  const QString name = current();
  if (document_ != nullptr) moveCamera(*document_, name, list_->currentRow() + step);
}

void CamerasPanel::removeCurrent() {
  if (document_ != nullptr) removeCamera(*document_, current());
}

void CamerasPanel::chooseNext(int step) {
  const int count = list_->count();
  if (count == 0) return;
  const int row = list_->currentRow() < 0 && step < 0 ? 0 : list_->currentRow();
  list_->setCurrentRow((row + step + count) % count);
  Q_EMIT cameraChosen(current());
}

bool CamerasPanel::eventFilter(QObject* watched, QEvent* event) {
  // Delete is a menu's key, for luminaires.
  if (watched == list_ &&
      (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete && list_->currentRow() >= 0) {
      event->accept();
      if (event->type() == QEvent::KeyPress) removeCurrent();
      return true;
    }
    if (event->type() == QEvent::KeyPress && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      Q_EMIT cameraChosen(current());
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace soffit::ui
