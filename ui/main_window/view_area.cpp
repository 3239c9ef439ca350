// SPDX-License-Identifier: MIT
#include "ui/main_window/view_area.h"

#include "core/render/difference_picture.h"

#include <QPainter>
#include <QResizeEvent>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr int kLegendMargin = 16;
constexpr int kStripMargin = 6;

}  // namespace

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent),
      grid_(new ViewGrid(*this)),
      comparison_(new ComparisonView(view(), *this)),
      legend_(new Legend(this)),
      profile_(new ProfileChart(this)),
      notice_(new QLabel(this)) {
  legend_->hide();
  profile_->hide();
  notice_->setAttribute(Qt::WA_TransparentForMouseEvents);
  notice_->setAlignment(Qt::AlignCenter);
  notice_->setStyleSheet(QStringLiteral(
      "color: #eef0f4; background: rgba(20, 22, 26, 190); border-radius: 6px; padding: 8px 14px;"));
  notice_->hide();
  setMinimumSize(320, 240);
  connect(legend_, &Legend::editRequested, this, &ViewArea::scaleRequested);
  connect(comparison_, &ComparisonView::layoutChanged, this, &ViewArea::layOut);
  connect(grid_, &ViewGrid::arrangementChanged, this, &ViewArea::layOut);
  addOverlays();
  // The first to hear: whoever hears it after finds them there.
  connect(grid_, &ViewGrid::shownChanged, this, &ViewArea::addOverlays);
}

void ViewArea::addOverlays() {
  while (overlays_.size() < grid_->count()) {
    SceneView& view = grid_->pane(overlays_.size()).view();
    auto* errors = new ErrorMap(view, overlays_.empty());
    overlays_.push_back({errors, new LuxOverlay(view)});
  }
}

Result<void> ViewArea::setLook(const Look& look, const std::vector<double>& levels, bool values) {
  auto set = grid_->setLook(look);
  plane_levels_ = levels;
  plane_values_ = values;
  showLegend();
  for (const Overlay& overlay : overlays_) overlay.marks->refresh();
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
    const Look& look = view().look();
    legend_->setScale(look.scale, look.levels.empty() ? plane_levels_ : look.levels);
  }
  const bool before = legend_->isVisibleTo(this);
  legend_->setVisible(difference_ > 0.0 || view().look().false_color || plane_values_ ||
                      !view().look().levels.empty() || !plane_levels_.empty());
  if (before != legend_->isVisibleTo(this)) layOut();
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
  const QSize legend = legend_->sizeHint();
  // Over one picture the legend takes a place that can be spared; of several it would hide one.
  const bool strip = !compared && grid_->arranged() > 1 && legend_->isVisibleTo(this);
  const int margin = strip ? kStripMargin : kLegendMargin;
  const QRect views = rect().adjusted(0, 0, strip ? -(legend.width() + 2 * margin) : 0, 0);
  const QRect first = comparison_->layOut(views);
  grid_->layOut(first, compared, comparison_->barEnd());
  comparison_->bar().raise();
  legend_->raise();
  notice_->raise();
  const int top = std::max(margin, comparison_->barEnd() + kStripMargin);
  legend_->setGeometry(width() - legend.width() - margin, top, legend.width(),
                       std::min(legend.height(), height() - top - margin));
  profile_->raise();
  const QSize chart = profile_->sizeHint().boundedTo(size() - QSize(32, 32));
  profile_->setGeometry(16, height() - chart.height() - 16, chart.width(), chart.height());
  notice_->move((width() - notice_->width()) / 2, (height() - notice_->height()) / 2);
}

}  // namespace soffit::ui
