// SPDX-License-Identifier: MIT
#include "ui/actions/command_palette.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSettings>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr int kLatest = 5;
constexpr QSize kSize(560, 360);
const QString kLatestKey = QStringLiteral("keys/latest");

}  // namespace

CommandPalette::CommandPalette(std::vector<Command> commands, QWidget* parent)
    : QDialog(parent),
      commands_(std::move(commands)),
      line_(new QLineEdit),
      list_(new QTreeWidget) {
  setObjectName(QStringLiteral("palette"));
  setWindowTitle(tr("Commands"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QStringList latest = QSettings().value(kLatestKey).toStringList();
  for (auto it = latest.rbegin(); it != latest.rend(); ++it) {
    const auto found = std::find_if(commands_.begin(), commands_.end(),
                                    [&](const Command& c) { return c.id == *it; });
    if (found != commands_.end()) std::rotate(commands_.begin(), found, found + 1);
  }
  line_->setPlaceholderText(tr("Name of a command"));
  line_->setClearButtonEnabled(true);
  line_->installEventFilter(this);
  list_->setColumnCount(3);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  auto* box = new QVBoxLayout(this);
  box->addWidget(line_);
  box->addWidget(list_);
  connect(line_, &QLineEdit::textChanged, this, &CommandPalette::fill);
  connect(list_, &QTreeWidget::itemActivated, this, &CommandPalette::run);
  connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::run);
  resize(kSize);
  fill({});
}

void CommandPalette::fill(const QString& text) {
  shown_ = commandsMatching(commands_, text);
  list_->clear();
  for (const Command& c : shown_) {
    auto* item = new QTreeWidgetItem(
        list_, {c.name, c.place, c.action->shortcut().toString(QKeySequence::NativeText)});
    item->setForeground(1, palette().brush(QPalette::PlaceholderText));
    item->setToolTip(0, c.action->toolTip());
    if (c.action->isCheckable()) {
      item->setCheckState(0, c.action->isChecked() ? Qt::Checked : Qt::Unchecked);
    }
  }
  if (!shown_.empty()) list_->setCurrentItem(list_->topLevelItem(0));
}

void CommandPalette::run() {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  if (row < 0) return;
  const Command command = shown_[static_cast<std::size_t>(row)];
  QSettings settings;
  QStringList latest = settings.value(kLatestKey).toStringList();
  latest.removeAll(command.id);
  latest.prepend(command.id);
  settings.setValue(kLatestKey, QStringList(latest.mid(0, kLatest)));
  accept();
  // After this window has gone: the command may open one of its own.
  if (command.action != nullptr) {
    QTimer::singleShot(0, command.action.data(), &QAction::trigger);
  }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
        QApplication::sendEvent(list_, event);
        return true;
      case Qt::Key_Return:
      case Qt::Key_Enter:
        run();
        return true;
      default:
        break;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace soffit::ui
