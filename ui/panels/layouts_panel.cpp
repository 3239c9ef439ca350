// SPDX-License-Identifier: MIT
#include "ui/panels/layouts_panel.h"

#include "ui/document/text.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace soffit::ui {

LayoutsPanel::LayoutsPanel(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), duplicate_(new QToolButton) {
  duplicate_->setText(tr("Duplicate"));
  duplicate_->setToolTip(tr("A copy of this layout to change (what is shared stays shared)"));
  list_->setAccessibleName(tr("Layouts"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addWidget(list_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(duplicate_);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  connect(duplicate_, &QToolButton::clicked, this, &LayoutsPanel::duplicateShown);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (following_ || document_ == nullptr || row < 0) return;
    document_->setLayout(list_->item(row)->data(Qt::UserRole).toString());
  });
}

void LayoutsPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &LayoutsPanel::refresh);
    connect(document_, &Document::layoutChanged, this, &LayoutsPanel::refresh);
  }
  refresh();
}

void LayoutsPanel::refresh() {
  following_ = true;
  QStringList names{QString()};
  if (document_ != nullptr) {
    for (const scene::Layout& layout : document_->scene()->layouts) names.append(toQt(layout.name));
  }
  QStringList shown;
  for (int i = 0; i < list_->count(); ++i)
    shown.append(list_->item(i)->data(Qt::UserRole).toString());
  if (shown != names) {
    list_->clear();
    for (const QString& name : names) {
      auto* item = new QListWidgetItem(name.isEmpty() ? tr("Base") : name, list_);
      item->setData(Qt::UserRole, name);
      if (name.isEmpty()) item->setToolTip(tr("What all layouts have in common"));
    }
  }
  if (document_ != nullptr) {
    list_->setCurrentRow(static_cast<int>(names.indexOf(document_->layout())));
  }
  duplicate_->setEnabled(document_ != nullptr);
  following_ = false;
}

void LayoutsPanel::duplicateShown() {
  if (document_ == nullptr) return;
  const QString source = document_->layout();
  const QString stem = source.isEmpty() ? tr("Layout") : source;
  QString name = stem + QStringLiteral(" 2");
  for (int i = 3; scene::findLayout(*document_->scene(), toStd(name)) != nullptr; ++i) {
    name = stem + QLatin1Char(' ') + QString::number(i);
  }
  auto next = scene::withLayout(*document_->scene(), toStd(name), toStd(source));
  if (!next) return;
  document_->edit(tr("Duplicate layout"), std::move(*next));
  document_->setLayout(name);
}

}  // namespace soffit::ui
