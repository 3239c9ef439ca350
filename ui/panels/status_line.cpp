// SPDX-License-Identifier: MIT
#include "ui/panels/status_line.h"

#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include <cmath>

namespace soffit::ui {
namespace {

constexpr qint64 kBeforeGuessMs = 1500;

/// Luminance stays in cd/m^2 everywhere; its numbers are spelled like those of illuminance.
QString candelas(double value) {
  if (value >= 100.0) return QString::number(std::lround(value));
  return formatNumber(value, 3, 'g');
}

}  // namespace

StatusLine::StatusLine(QStatusBar* bar)
    : QObject(bar),
      place_(new QLabel),
      light_(new QLabel),
      quality_(new QLabel),
      evaluation_(new QLabel),
      verified_(new QLabel),
      hint_(new QLabel),
      stage_(new QLabel),
      progress_(new QProgressBar),
      cancel_(new QToolButton) {
  const QFontMetrics metrics = bar->fontMetrics();
  light_->setMinimumWidth(
      metrics.horizontalAdvance(QStringLiteral("00000 lx   0000.0 cd/m\u00b2")));
  light_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  QFont bold = light_->font();
  bold.setBold(true);
  light_->setFont(bold);
  place_->setMinimumWidth(metrics.horizontalAdvance(QStringLiteral("00.00  00.00  00.00 m")));
  place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  place_->setToolTip(tr("Place under the cursor"));
  light_->setToolTip(tr("Illuminance of the surface under the cursor, and its diffuse luminance"));
  quality_->setToolTip(
      tr("State of the light; milliseconds of its last update and of the last picture"));
  verified_->setToolTip(tr("The light that is shown was compared with the path tracer"));
  verified_->setFont(bold);
  verified_->hide();
  evaluation_->setObjectName(QStringLiteral("evaluation"));
  evaluation_->hide();
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(140);
  progress_->setFixedHeight(10);
  cancel_->setText(tr("Cancel"));
  bar->setSizeGripEnabled(false);
  bar->setContentsMargins(6, 0, 8, 0);
  bar->addWidget(hint_);
  bar->addWidget(stage_);
  bar->addWidget(progress_);
  bar->addWidget(cancel_);
  bar->addPermanentWidget(place_);
  bar->addPermanentWidget(light_);
  bar->addPermanentWidget(quality_);
  bar->addPermanentWidget(evaluation_);
  bar->addPermanentWidget(verified_);
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelRequested);
  light_->installEventFilter(this);
  endProgress();
}

void StatusLine::showProgress(const QString& stage, double done) {
  if (stage != known_stage_) {
    known_stage_ = stage;
    stage_time_.start();
  }
  QString text = stage;
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  const qint64 elapsed = stage_time_.elapsed();
  if (elapsed > kBeforeGuessMs && done > 0.05 && done < 1.0) {
    const double left = static_cast<double>(elapsed) * (1.0 - done) / done / 1000.0;
    text += tr(", %1 s left").arg(std::max<long>(1, std::lround(left)));
  }
  stage_->setText(text);
  progress_->setValue(static_cast<int>(std::lround(1000.0 * done)));
  stage_->show();
  progress_->show();
  cancel_->show();
}

void StatusLine::endProgress() {
  known_stage_.clear();
  stage_->hide();
  progress_->hide();
  cancel_->hide();
}

void StatusLine::showHint(const QString& hint) {
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
}

void StatusLine::showReading(const std::optional<SurfaceReading>& reading) {
  reading_ = reading;
  if (!reading) {
    place_->clear();
    light_->clear();
    return;
  }
  const dvec3& p = reading->position;
  const double metre = shownUnit(Dimension::length);
  place_->setText(QStringLiteral("%1  %2  %3 %4")
                      .arg(formatNumber(p.x / metre, 2), formatNumber(p.y / metre, 2),
                           formatNumber(p.z / metre, 2), unitOf(Dimension::length)));
  light_->setText(QStringLiteral("%1 %2   %3 cd/m\u00b2")
                      .arg(formatReading(reading->lux, Dimension::illuminance),
                           unitOf(Dimension::illuminance), candelas(reading->luminance)));
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == light_ && event->type() == QEvent::LocaleChange) showReading(reading_);
  return QObject::eventFilter(watched, event);
}

void StatusLine::showEvaluation(const QString& text, const QString& reason) {
  evaluation_->setText(text);
  evaluation_->setToolTip(reason);
  evaluation_->setVisible(!text.isEmpty());
}

void StatusLine::setVerified(const QString& text) {
  verified_->setText(text.isEmpty() ? text : QStringLiteral("\u2713 ") + text);
  verified_->setVisible(!text.isEmpty());
}

void StatusLine::showLight(const LightFrame& frame, double frame_ms) {
  const bool coarse = frame.solver->operators().coarse;
  quality_->setText(tr("%1 \u00b7 light %2 ms \u00b7 picture %3 ms")
                        .arg(coarse ? tr("Preview") : tr("Converged"))
                        .arg(frame.milliseconds, 0, 'f', 0)
                        .arg(frame_ms, 0, 'f', 0));
}

}  // namespace soffit::ui
