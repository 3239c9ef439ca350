// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/picture_file.h"
#include "ui/jobs/background.h"
#include "ui/jobs/progress_relay.h"
#include "ui/viewport/still_renderer.h"
#include "ui/viewport/traced_still.h"

#include <QObject>

#include <functional>
#include <stop_token>

namespace soffit::ui {

/// A picture to be made, and where it goes.
struct PictureOrder {
  Still still;
  PictureFile file;  ///< without its picture; path: empty for one that is not written
};

struct PictureOutcome {
  bool cancelled = false;
  QString error;  ///< empty: it was made, and written if it has a path
  QImage image;   ///< with marks, legend and title, if it has none
};

/// Makes pictures of views in the background, one after the other, and writes them. Where the
/// graphics driver knows one thread alone, that is this one and it takes its time.
class PictureJob : public QObject {
  Q_OBJECT

 public:
  using End = std::function<void(const PictureOutcome&)>;

  PictureJob();
  ~PictureJob() override;

  /// `end` is called in this thread, not before this returns.
  void take(PictureOrder order, End end);
  /// Gives up the picture under way and those that wait. A file is written whole or not at all.
  void cancel();
  [[nodiscard]] bool isBusy() const { return under_way_ > 0; }

 Q_SIGNALS:
  /// Of the picture under way, 0..1.
  void progressed(double done);

 private:
  PictureOutcome make(PictureOrder& order, const std::stop_token& stop);

  int under_way_ = 0;
  bool holds_memory_ = false;  ///< of the graphics card
  std::stop_source stop_;
  ProgressRelay relay_;
  StillRenderer renderer_;
  TracedStill tracer_;
  Background background_;
};

}  // namespace soffit::ui
