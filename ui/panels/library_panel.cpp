// SPDX-License-Identifier: MIT
#include "ui/panels/library_panel.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QRegularExpression>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace soffit::ui {
namespace {

const QString kFolders = QStringLiteral("library/folders");
constexpr int kIcon = 44;

}  // namespace

LibraryPanel::LibraryPanel(QWidget* parent)
    : QWidget(parent), search_(new QLineEdit), list_(new QListView), state_(new QLabel) {
  shown_.setSourceModel(&model_);
  shown_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  search_->setPlaceholderText(tr("Search: name, lumens, angle"));
  search_->setClearButtonEnabled(true);
  list_->setModel(&shown_);
  list_->setIconSize({kIcon, kIcon});
  list_->setUniformItemSizes(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setResizeMode(QListView::Adjust);
  list_->setDragEnabled(true);
  list_->setDragDropMode(QAbstractItemView::DragOnly);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setAccessibleName(tr("Kinds of luminaires"));
  list_->setToolTip(tr("Click, then click in the view; or drag it there"));
  state_->setForegroundRole(QPalette::PlaceholderText);
  state_->setWordWrap(true);
  auto* folders = new QToolButton;
  folders->setText(tr("Folders"));
  folders->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(folders);
  folders->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    menu->addAction(tr("Add a folder of IES and LDT files\u2026"), this, &LibraryPanel::askFolder);
    if (!this->folders().isEmpty()) menu->addSeparator();
    for (const QString& folder : this->folders()) {
      menu->addAction(tr("Forget %1").arg(folder), this, [this, folder] {
        QStringList rest = this->folders();
        rest.removeAll(folder);
        QSettings().setValue(kFolders, rest);
        reindex();
      });
    }
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addWidget(search_);
  layout->addWidget(list_, 1);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(folders);
  bottom->addWidget(state_, 1);
  layout->addLayout(bottom);
  connect(search_, &QLineEdit::textChanged, this, &LibraryPanel::setSearch);
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) {
    Q_EMIT chosen(model_.type(shown_.mapToSource(index).row()));
  });
  connect(&index_, &LibraryIndex::found, this, [this] { model_.add(index_.take()); });
  connect(&index_, &LibraryIndex::finished, this, [this](int unreadable) {
    model_.add(index_.take());
    state_->setText(unreadable == 0 ? QString()
                                    : tr("%n files could not be read", nullptr, unreadable));
    Q_EMIT indexed(unreadable);
  });
  reindex();
}

QStringList LibraryPanel::folders() const {
  return QSettings().value(kFolders).toStringList();
}

void LibraryPanel::askFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of photometric files"));
  if (!folder.isEmpty()) addFolder(folder);
}

void LibraryPanel::addFolder(const QString& folder) {
  QStringList all = folders();
  if (!all.contains(folder)) all.append(folder);
  QSettings().setValue(kFolders, all);
  reindex();
}

void LibraryPanel::reindex() {
  model_.dropUserTypes();
  const QStringList all = folders();
  state_->setText(all.isEmpty() ? QString() : tr("Reading\u2026"));
  index_.start(all);
}

void LibraryPanel::setSearch(const QString& words) {
  if (search_->text() != words) {
    search_->setText(words);
    return;
  }
  // Every word, in any order.
  QString pattern;
  for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    pattern += QStringLiteral("(?=.*%1)").arg(QRegularExpression::escape(word));
  }
  shown_.setFilterRegularExpression(QRegularExpression(
      pattern,
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::DotMatchesEverythingOption));
}

}  // namespace soffit::ui
