// SPDX-License-Identifier: MIT
#include "ui/main_window/view_area.h"

#include "core/render/difference_picture.h"

#include <QPainter>
#include <QResizeEvent>

#include <algorithm>

namespace soffit::ui {

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent),
      grid_(new ViewGrid(*this)),
      comparison_(new ComparisonView(view(), *this)),
      errors_(new ErrorMap(view())),
      legend_(new Legend(this)),
      notice_(new QLabel(this)) {
  legend_->hide();
  notice_->setAttribute(Qt::WA_TransparentForMouseEvents);
  notice_->setAlignment(Qt::AlignCenter);
  notice_->setStyleSheet(QStringLiteral(
      "color: #eef0f4; background: rgba(20, 22, 26, 190); border-radius: 6px; padding: 8px 14px;"));
  notice_->hide();
  setMinimumSize(320, 240);
  connect(comparison_, &ComparisonView::layoutChanged, this, &ViewArea::layOut);
  connect(grid_, &ViewGrid::arrangementChanged, this, &ViewArea::layOut);
}

Result<void> ViewArea::setLook(const Look& look) {
  const auto set = grid_->setLook(look);
  showLegend();
  return set;
}

void ViewArea::setDifferenceScale(double range) {
  difference_ = range;
  showLegend();
}

void ViewArea::showLegend() {
  if (difference_ > 0.0) {
    legend_->setScale(
        [](float place) { return render::differenceColor(2.0F * place - 1.0F); },
        [range = difference_](int most) { return render::differenceTicks(range, most); });
  } else {
    legend_->setRange(view().look().range);
  }
  legend_->setVisible(difference_ > 0.0 || view().look().false_color);
}

void ViewArea::setNotice(const QString& text) {
  notice_->setText(text);
  notice_->setVisible(!text.isEmpty());
  notice_->adjustSize();
  notice_->move((width() - notice_->width()) / 2, (height() - notice_->height()) / 2);
}

void ViewArea::resizeEvent(QResizeEvent*) {
  layOut();
}

void ViewArea::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  grid_->paint(painter);
}

void ViewArea::layOut() {
  const bool compared = comparison_->mode() != ComparisonMode::off;
  grid_->layOut(comparison_->layOut(rect()), compared);
  legend_->raise();
  notice_->raise();
  const int tall = std::min(legend_->sizeHint().height(), height() - 32);
  legend_->setGeometry(width() - legend_->sizeHint().width() - 16, 16, legend_->sizeHint().width(),
                       tall);
  notice_->move((width() - notice_->width()) / 2, (height() - notice_->height()) / 2);
}

}  // namespace soffit::ui
