// SPDX-License-Identifier: MIT
#include "ui/jobs/live_readings.h"

#include "ui/document/text.h"

#include <algorithm>

namespace soffit::ui {
namespace {

/// Readings cost as much as the picture's light: in a drag, where both want the same cores, numbers
/// that change four times a second are all that can be read anyway.
constexpr int kPauseMs = 250;

}  // namespace

LiveReadings::LiveReadings(Document& document, Relighting& relighting, QObject* parent)
    : QObject(parent), document_(document), relighting_(relighting) {
  connect(&relighting_, &Relighting::frameChanged, this, &LiveReadings::onFrame);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, &LiveReadings::request);
  connect(&worker_, &ReadingsWorker::failed, this, &LiveReadings::failed);
  connect(&worker_, &ReadingsWorker::ready, this, [this] {
    ReadingsPtr readings = worker_.take();
    if (readings == nullptr) return;
    readings_ = std::move(readings);
    Q_EMIT changed();
  });
}

void LiveReadings::setBaseWanted(bool wanted) {
  if (wanted == base_wanted_) return;
  base_wanted_ = wanted;
  request();
}

bool LiveReadings::isCurrent() const {
  if (readings_ == nullptr || readings_->revision != relighting_.revision()) return false;
  const std::size_t layouts = document_.scene()->layouts.size();
  const bool with_base = base_wanted_ || document_.layout().isEmpty() || layouts == 0;
  return readings_->layouts.size() == layouts + (with_base ? 1U : 0U) &&
         std::ranges::all_of(readings_->layouts, &LayoutReading::current);
}

void LiveReadings::onFrame() {
  // Exact light from outside is on its way.
  if (!relighting_.frame()->complete) return;
  if (!document_.previewing()) {
    request();
  } else if (!pause_.isActive()) {
    // Of the place that the hand has reached by then.
    pause_.start();
  }
}

void LiveReadings::request() {
  pause_.stop();
  const LightFramePtr& frame = relighting_.frame();
  if (frame == nullptr || !frame->complete) return;
  ReadingsRequest request;
  request.solver = frame->solver;
  request.outside = frame->outside;
  request.scene = document_.scene();
  request.shown = toStd(document_.layout());
  request.luminaires = document_.luminaires();
  request.folder = document_.project().path.parent_path();
  request.with_base = base_wanted_;
  request.dragging = document_.previewing();
  request.revision = relighting_.revision();
  worker_.request(std::move(request));
}

}  // namespace soffit::ui
