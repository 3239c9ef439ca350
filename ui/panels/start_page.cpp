// SPDX-License-Identifier: MIT
#include "ui/panels/start_page.h"

#include "core/color/display_config.h"
#include "ui/document/recent_files.h"
#include "ui/document/text.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace soffit::ui {
namespace {

constexpr QSize kThumbnail(268, 168);

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  font.setPointSizeF(1.15 * font.pointSizeF());
  label->setFont(font);
  return label;
}

QPixmap thumbnailOf(const QString& project) {
  const auto folder = color::findResource("pictures");
  if (!folder) return {};
  const QString stem = QFileInfo(project).completeBaseName();
  return {QDir(toQt(*folder)).filePath(stem + QStringLiteral(".jpg"))};
}

QString titleOf(const QString& project) {
  QString stem = QFileInfo(project).completeBaseName();
  if (!stem.isEmpty()) stem[0] = stem[0].toUpper();
  return stem;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(48, 32, 48, 32);
  refresh();
}

QWidget* StartPage::makeSamples() {
  auto* grid = new QWidget;
  auto* layout = new QGridLayout(grid);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(14);
  int i = 0;
  for (const QString& path : sampleProjects()) {
    auto* card = new QToolButton;
    card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    card->setIconSize(kThumbnail);
    card->setIcon(QIcon(thumbnailOf(path).scaled(kThumbnail * devicePixelRatioF(),
                                                 Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    card->setText(titleOf(path));
    card->setToolTip(path);
    card->setAutoRaise(true);
    card->setCursor(Qt::PointingHandCursor);
    connect(card, &QToolButton::clicked, this, [this, path] { Q_EMIT chosen(path); });
    layout->addWidget(card, i / 2, i % 2);
    ++i;
  }
  layout->setColumnStretch(2, 1);
  return grid;
}

QWidget* StartPage::makeRecent() {
  auto* list = new QListWidget;
  list->setAccessibleName(tr("Recent projects"));
  for (const QString& path : recentFiles()) {
    auto* item =
        new QListWidgetItem(titleOf(path) + QLatin1Char('\n') + QDir::toNativeSeparators(path));
    item->setData(Qt::UserRole, path);
    list->addItem(item);
  }
  if (list->count() == 0) {
    auto* item = new QListWidgetItem(tr("Projects that you open appear here."));
    item->setFlags(Qt::NoItemFlags);
    list->addItem(item);
  }
  list->setSpacing(2);
  list->setMinimumWidth(380);
  list->setTextElideMode(Qt::ElideMiddle);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    const QString path = item->data(Qt::UserRole).toString();
    if (!path.isEmpty()) Q_EMIT chosen(path);
  });
  return list;
}

void StartPage::refresh() {
  delete content_;
  content_ = new QWidget;
  auto* columns = new QHBoxLayout(content_);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(40);
  auto* left = new QVBoxLayout;
  left->setSpacing(6);
  left->addWidget(heading(tr("Sample projects")));
  left->addSpacing(6);
  left->addWidget(makeSamples());
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  right->setSpacing(6);
  right->addWidget(heading(tr("Recent projects")));
  right->addSpacing(6);
  right->addWidget(makeRecent(), 1);
  auto* open = new QPushButton(tr("Open a project\u2026"));
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  auto* import = new QPushButton(tr("Import a building\u2026"));
  import->setToolTip(
      tr("A model as glTF, OBJ, IFC, FBX, Collada, 3DS, PLY or STL; it can also be "
         "dropped on this window"));
  connect(import, &QPushButton::clicked, this, &StartPage::importRequested);
  auto* fresh = new QPushButton(tr("New project"));
  connect(fresh, &QPushButton::clicked, this, &StartPage::newRequested);
  right->addSpacing(6);
  right->addWidget(open);
  auto* others = new QHBoxLayout;
  others->addWidget(import, 1);
  others->addWidget(fresh, 1);
  right->addLayout(others);
  columns->addLayout(left);
  columns->addLayout(right);
  columns->addStretch(1);
  column_->addWidget(content_);
}

}  // namespace soffit::ui
