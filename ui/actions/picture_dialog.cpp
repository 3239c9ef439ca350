// SPDX-License-Identifier: MIT
#include "ui/actions/picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace soffit::ui {
namespace {

QListWidget* checkList(const QStringList& names, const QString& accessible) {
  auto* list = new QListWidget;
  list->setAccessibleName(accessible);
  for (const QString& name : names) {
    auto* item = new QListWidgetItem(name.isEmpty() ? PictureDialog::tr("Base") : name, list);
    item->setData(Qt::UserRole, name);
    item->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled);
    item->setCheckState(name.isEmpty() && names.size() > 1 ? Qt::Unchecked : Qt::Checked);
  }
  return list;
}

QStringList checkedOf(const QListWidget* list) {
  QStringList names;
  for (int i = 0; list != nullptr && i < list->count(); ++i) {
    if (list->item(i)->checkState() == Qt::Checked) {
      names.append(list->item(i)->data(Qt::UserRole).toString());
    }
  }
  return names;
}

}  // namespace

PictureDialog::PictureDialog(const QSize& view, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Export the view"));
  build(view);
}

PictureDialog::PictureDialog(const QSize& view, const QStringList& cameras,
                             const QStringList& layouts, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Export a set of pictures"));
  cameras_ = checkList(cameras, tr("Cameras"));
  layouts_ = checkList(layouts, tr("Layouts"));
  count_ = new QLabel;
  build(view);
  connect(cameras_, &QListWidget::itemChanged, this, &PictureDialog::updateButtons);
  connect(layouts_, &QListWidget::itemChanged, this, &PictureDialog::updateButtons);
  resize(520, 440);
}

void PictureDialog::build(const QSize& view) {
  preset_ = new QComboBox;
  preset_->addItem(tr("As the view, %1 \u00d7 %2").arg(view.width()).arg(view.height()), view);
  preset_->addItem(tr("Twice the view, %1 \u00d7 %2").arg(2 * view.width()).arg(2 * view.height()),
                   2 * view);
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)}) {
    preset_->addItem(QStringLiteral("%1 \u00d7 %2").arg(size.width()).arg(size.height()), size);
  }
  preset_->addItem(tr("Other"), QSize());
  width_ = new QSpinBox;
  height_ = new QSpinBox;
  for (QSpinBox* box : {width_, height_}) {
    box->setRange(16, kLargestPicture);
    box->setSuffix(tr(" px"));
  }
  format_ = new QComboBox;
  format_->addItem(tr("PNG, as it is seen"), QStringLiteral("png"));
  format_->addItem(tr("JPEG, as it is seen"), QStringLiteral("jpg"));
  format_->addItem(tr("TIFF, as it is seen"), QStringLiteral("tif"));
  format_->addItem(tr("OpenEXR, luminance in cd/m\u00b2"), QStringLiteral("exr"));
  rendering_ = new QComboBox;
  rendering_->addItem(tr("As the live view"), false);
  rendering_->addItem(tr("Ray traced: reflections, exact shadows"), true);
  rendering_->setToolTip(
      tr("Ray traced pictures take seconds to minutes. False colours, isolux lines and flat "
         "views are always drawn live."));
  legend_ = new QCheckBox(tr("Legend of false colours"));
  legend_->setChecked(true);
  title_ = new QCheckBox(tr("Title: project, layout and camera"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Export\u2026"));
  accept_ = buttons->button(QDialogButtonBox::Ok);

  auto* layout = new QVBoxLayout(this);
  if (cameras_ != nullptr) {
    auto* lists = new QHBoxLayout;
    for (QListWidget* list : {cameras_, layouts_}) {
      auto* column = new QVBoxLayout;
      column->addWidget(new QLabel(list->accessibleName()));
      column->addWidget(list);
      lists->addLayout(column);
    }
    layout->addLayout(lists, 1);
    layout->addWidget(count_);
  }
  auto* form = new QFormLayout;
  auto* size = new QHBoxLayout;
  size->addWidget(width_);
  size->addWidget(new QLabel(QStringLiteral("\u00d7")));
  size->addWidget(height_);
  size->addStretch(1);
  form->addRow(tr("Size"), preset_);
  form->addRow(QString(), size);
  form->addRow(tr("Rendering"), rendering_);
  form->addRow(tr("Format"), format_);
  form->addRow(QString(), legend_);
  form->addRow(QString(), title_);
  layout->addLayout(form);
  layout->addWidget(buttons);
  connect(preset_, &QComboBox::currentIndexChanged, this, &PictureDialog::takePreset);
  connect(format_, &QComboBox::currentIndexChanged, this, [this] {
    const bool seen = format() != QLatin1String("exr");
    legend_->setEnabled(seen);
    title_->setEnabled(seen);
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  takePreset();
  updateButtons();
}

void PictureDialog::takePreset() {
  const QSize size = preset_->currentData().toSize();
  for (QSpinBox* box : {width_, height_}) box->setEnabled(!size.isValid() || size.isEmpty());
  if (size.isEmpty()) return;
  width_->setValue(size.width());
  height_->setValue(size.height());
}

void PictureDialog::updateButtons() {
  if (cameras_ == nullptr) return;
  const auto count = cameras().size() * layouts().size();
  count_->setText(tr("%n picture(s)", nullptr, static_cast<int>(count)));
  accept_->setEnabled(count > 0);
}

QSize PictureDialog::pixels() const {
  return {width_->value(), height_->value()};
}

QString PictureDialog::format() const {
  return format_->currentData().toString();
}

bool PictureDialog::legend() const {
  return legend_->isChecked();
}

bool PictureDialog::title() const {
  return title_->isChecked();
}

void PictureDialog::setTraced(bool traced) {
  rendering_->setCurrentIndex(rendering_->findData(traced));
}

bool PictureDialog::traced() const {
  return rendering_->currentData().toBool();
}

QStringList PictureDialog::cameras() const {
  return checkedOf(cameras_);
}

QStringList PictureDialog::layouts() const {
  return checkedOf(layouts_);
}

}  // namespace soffit::ui
