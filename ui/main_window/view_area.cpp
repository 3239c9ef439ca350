// SPDX-License-Identifier: MIT
#include "ui/main_window/view_area.h"

#include <QResizeEvent>

#include <algorithm>

namespace soffit::ui {

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent),
      view_(new SceneView(this)),
      input_(new ViewInput(*view_, this)),
      legend_(new Legend(this)),
      notice_(new QLabel(this)) {
  legend_->hide();
  notice_->setAttribute(Qt::WA_TransparentForMouseEvents);
  notice_->setAlignment(Qt::AlignCenter);
  notice_->setStyleSheet(QStringLiteral(
      "color: #eef0f4; background: rgba(20, 22, 26, 190); border-radius: 6px; padding: 8px 14px;"));
  notice_->hide();
  setMinimumSize(320, 240);
}

Result<void> ViewArea::setLook(const Look& look) {
  legend_->setRange(look.range);
  legend_->setVisible(look.false_color);
  return view_->setLook(look);
}

void ViewArea::setNotice(const QString& text) {
  notice_->setText(text);
  notice_->setVisible(!text.isEmpty());
  notice_->adjustSize();
  notice_->move((width() - notice_->width()) / 2, (height() - notice_->height()) / 2);
}

void ViewArea::resizeEvent(QResizeEvent*) {
  view_->setGeometry(rect());
  const int tall = std::min(legend_->sizeHint().height(), height() - 32);
  legend_->setGeometry(width() - legend_->sizeHint().width() - 16, 16, legend_->sizeHint().width(),
                       tall);
  notice_->move((width() - notice_->width()) / 2, (height() - notice_->height()) / 2);
}

}  // namespace soffit::ui
