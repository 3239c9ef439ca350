// SPDX-License-Identifier: MIT
#include "ui/main_window/comparison_view.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr int kBlinkMs = 700;
constexpr int kSliderWidth = 8;  ///< px, to take hold of
constexpr int kMargin = 12;
const QString kNameStyle = QStringLiteral(
    "color: #eef0f4; background: rgba(20, 22, 26, 190); border-radius: 4px; padding: 3px 8px;");

QLabel* nameLabel(QWidget* area) {
  auto* label = new QLabel(area);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  label->setStyleSheet(kNameStyle);
  label->hide();
  return label;
}

}  // namespace

ComparisonView::ComparisonView(SceneView& first, QWidget& area)
    : QObject(&area),
      first_(first),
      area_(area),
      clip_(new QWidget(&area)),
      slider_(new QWidget(&area)),
      first_name_(nameLabel(&area)),
      second_name_(nameLabel(&area)),
      bar_(new ComparisonBar(&area)) {
  clip_->hide();
  slider_->setObjectName(QStringLiteral("split_slider"));
  slider_->setCursor(Qt::SplitHCursor);
  slider_->setStyleSheet(
      QStringLiteral("#split_slider { background: #eef0f4; border: 0px; border-left: 3px solid "
                     "rgba(20, 22, 26, 110);"
                     " border-right: 3px solid rgba(20, 22, 26, 110); }"));
  slider_->setAttribute(Qt::WA_StyledBackground);
  slider_->setAccessibleName(tr("Split between the layouts"));
  slider_->installEventFilter(this);
  slider_->hide();
  bar_->hide();
  blink_.setInterval(kBlinkMs);
  connect(&blink_, &QTimer::timeout, this, &ComparisonView::blink);
  connect(&first_, &SceneView::cameraMoved, this, [this] {
    if (mode_ != ComparisonMode::off) second().setViewCamera(first_.viewCamera());
  });
  connect(&first_, &SceneView::movingChanged, this, [this](bool moving) {
    if (mode_ != ComparisonMode::off) second().setMoving(moving);
  });
}

SceneView& ComparisonView::second() {
  if (second_ == nullptr) {
    second_ = new SceneView(clip_);
    second_->installEventFilter(this);
    second_->setFocusProxy(&first_);
  }
  return *second_;
}

bool ComparisonView::showsSecond() const {
  return clip_->isVisible();
}

void ComparisonView::setMode(ComparisonMode mode) {
  mode_ = mode;
  const bool on = mode != ComparisonMode::off;
  blink_second_ = mode == ComparisonMode::blink;
  if (mode == ComparisonMode::blink) {
    blink_.start();
  } else {
    blink_.stop();
  }
  if (on) second().setViewCamera(first_.viewCamera());
  clip_->setVisible(on);
  slider_->setVisible(mode == ComparisonMode::split);
  bar_->setVisible(on);
  bar_->setMode(mode);
  showNames();
  Q_EMIT layoutChanged();
}

void ComparisonView::blink() {
  blink_second_ = !blink_second_;
  clip_->setVisible(blink_second_);
  showNames();
  Q_EMIT layoutChanged();
}

void ComparisonView::setSplit(double place) {
  split_ = std::clamp(place, 0.0, 1.0);
  Q_EMIT layoutChanged();
}

void ComparisonView::setNames(const QString& first, const QString& second) {
  names_[0] = first;
  names_[1] = second;
  showNames();
  Q_EMIT layoutChanged();
}

void ComparisonView::showNames() {
  const bool pair = mode_ == ComparisonMode::split || mode_ == ComparisonMode::side_by_side;
  const bool second = mode_ == ComparisonMode::blink && blink_second_;
  first_name_->setText(names_[second ? 1 : 0]);
  if (mode_ == ComparisonMode::difference) {
    first_name_->setText(tr("%1 \u2212 %2").arg(names_[1], names_[0]));
  }
  second_name_->setText(names_[1]);
  first_name_->setVisible(mode_ != ComparisonMode::off);
  second_name_->setVisible(pair);
}

int ComparisonView::barEnd() const {
  return mode_ == ComparisonMode::off ? 0 : bar_->y() + bar_->height();
}

QRect ComparisonView::layOut(const QRect& area) {
  QRect first = area;
  QRect clip = area;
  if (mode_ == ComparisonMode::side_by_side) {
    first.setWidth(area.width() / 2 - 1);
    clip = QRect(area.width() / 2 + 1, area.top(), first.width(), area.height());
  } else if (mode_ == ComparisonMode::split) {
    clip.setLeft(static_cast<int>(std::lround(split_ * area.width())));
  }
  if (second_ != nullptr && mode_ != ComparisonMode::off) {
    clip_->setGeometry(clip);
    const int left = mode_ == ComparisonMode::split ? -clip.left() : 0;
    second_->setGeometry(QRect(QPoint(left, 0), first.size()));
  }
  slider_->setGeometry(clip.left() - kSliderWidth / 2, area.top(), kSliderWidth, area.height());
  for (QLabel* label : {first_name_, second_name_}) label->adjustSize();
  const int bottom = area.bottom() - kMargin - first_name_->height();
  first_name_->move(area.left() + kMargin, bottom);
  second_name_->move(mode_ == ComparisonMode::split ? area.right() - kMargin - second_name_->width()
                                                    : clip.left() + kMargin,
                     bottom);
  const QSize bar = bar_->sizeHint().boundedTo({area.width(), area.height()});
  bar_->setGeometry((area.width() - bar.width()) / 2, kMargin, bar.width(), bar.height());
  for (QWidget* widget : {clip_, slider_}) widget->raise();
  for (QLabel* label : {first_name_, second_name_}) label->raise();
  bar_->raise();
  return first;
}

bool ComparisonView::forward(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
    case QEvent::Leave:
      QApplication::sendEvent(&first_, event);
      second_->setCursor(first_.cursor());
      return true;
    default:
      return false;
  }
}

bool ComparisonView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == second_) return forward(event);
  if (watched == slider_ && event->type() == QEvent::MouseMove) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if ((mouse->buttons() & Qt::LeftButton) == 0) return false;
    const double x = slider_->mapTo(&area_, mouse->position().toPoint()).x();
    setSplit(x / std::max(1, area_.width()));
    return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace soffit::ui
