// SPDX-License-Identifier: MIT
#include "ui/panels/log_panel.h"

#include <QPlainTextEdit>
#include <QTime>
#include <QVBoxLayout>

namespace soffit::ui {

LogPanel::LogPanel(QWidget* parent) : QWidget(parent), text_(new QPlainTextEdit) {
  text_->setReadOnly(true);
  text_->setMaximumBlockCount(5000);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setAccessibleName(tr("Log"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(text_);
}

void LogPanel::addLine(const QString& text) {
  text_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + text);
}

void LogPanel::addWarning(const QString& text) {
  addLine(tr("Warning: %1").arg(text));
}

}  // namespace soffit::ui
