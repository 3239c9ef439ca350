// SPDX-License-Identifier: MIT
#include "ui/actions/recovery_dialog.h"

#include "ui/document/state_folder.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace soffit::ui {
namespace {

constexpr QSize kThumbnail(128, 80);

}  // namespace

RecoveryDialog::RecoveryDialog(const QList<Recovery>& recoveries, QWidget* parent)
    : QDialog(parent), recoveries_(recoveries), list_(new QListWidget) {
  setWindowTitle(tr("Unsaved work was found"));
  auto* text = new QLabel(
      tr("Soffit did not end as it should. These versions were kept; the project files themselves "
         "are as you saved them last."));
  text->setWordWrap(true);
  list_->setIconSize(kThumbnail);
  list_->setAccessibleName(tr("Versions that were kept"));
  list_->setTextElideMode(Qt::ElideMiddle);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  for (const Recovery& recovery : recoveries_) {
    QPixmap picture(kThumbnail);
    picture.fill(Qt::transparent);
    if (!recovery.thumbnail.isNull()) picture = QPixmap::fromImage(recovery.thumbnail);
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);  // not tinted
    list_->addItem(new QListWidgetItem(
        icon,
        tr("%1\n%2\n%3")
            .arg(recovery.name, QLocale().toString(recovery.saved, QLocale::ShortFormat),
                 QDir::toNativeSeparators(recovery.path))));
  }
  list_->setCurrentRow(0);
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(tr("Recover"), QDialogButtonBox::AcceptRole)->setDefault(true);
  auto* discard = buttons->addButton(tr("Discard"), QDialogButtonBox::DestructiveRole);
  buttons->addButton(tr("Later"), QDialogButtonBox::RejectRole);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  resize(560, 340);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(discard, &QPushButton::clicked, this, &RecoveryDialog::discardChosen);
  connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
}

Recovery RecoveryDialog::chosen() const {
  const int row = list_->currentRow();
  return row < 0 ? Recovery() : recoveries_[row];
}

void RecoveryDialog::discardChosen() {
  const int row = list_->currentRow();
  if (row < 0) return;
  discardRecovery(recoveries_[row].id);
  removeUntitledProject(recoveries_[row].path);
  recoveries_.removeAt(row);
  delete list_->takeItem(row);
  if (recoveries_.isEmpty()) reject();
}

}  // namespace soffit::ui
