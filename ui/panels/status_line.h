// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"

#include <QElapsedTimer>
#include <QObject>

#include <optional>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace soffit::ui {

/// The fields of the status bar: progress with Cancel, place and light under the cursor, how good
/// and how fast the light is.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  explicit StatusLine(QStatusBar* bar);

  void showProgress(const QString& stage, double done);
  void endProgress();
  /// What the tool at work asks for; empty: none is.
  void showHint(const QString& hint);
  void showReading(const std::optional<SurfaceReading>& reading);
  void showLight(const LightFrame& frame, double frame_ms);
  /// Which processor evaluates light in the views, in a word, and why.
  void showEvaluation(const QString& text, const QString& reason);
  /// What the reference said of the light that is shown; empty: nothing.
  void setVerified(const QString& text);

 Q_SIGNALS:
  void cancelRequested();

 protected:
  /// Other units: the reading is told in them.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLabel* place_;
  QLabel* light_;
  QLabel* quality_;
  QLabel* evaluation_;
  QLabel* verified_;
  QLabel* hint_;
  QLabel* stage_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  std::optional<SurfaceReading> reading_;
  QString known_stage_;
  QElapsedTimer stage_time_;
};

}  // namespace soffit::ui
