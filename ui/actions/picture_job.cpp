// SPDX-License-Identifier: MIT
#include "ui/actions/picture_job.h"

#include "ui/document/text.h"

#include <QTimer>

#include <memory>
#include <new>
#include <utility>

namespace soffit::ui {

PictureJob::PictureJob() {
  connect(&relay_, &ProgressRelay::progressed, this,
          [this](const QString&, double done) { Q_EMIT progressed(done); });
  connect(&background_, &Background::idle, this, [this] {
    if (!std::exchange(holds_memory_, false)) return;
    background_.run([this]() -> Background::End {
      renderer_.release();
      tracer_.release();
      return {};
    });
  });
}

PictureJob::~PictureJob() {
  disconnect(&background_, nullptr, this, nullptr);
  stop_.request_stop();
}

void PictureJob::cancel() {
  stop_.request_stop();
  stop_ = std::stop_source();
}

PictureOutcome PictureJob::make(PictureOrder& order, const std::stop_token& stop) {
  PictureOutcome outcome;
  try {
    const Job job{&relay_, stop};
    const bool traced = order.still.shot.traced && isTraceable(order.still);
    auto picture = traced ? tracer_.draw(order.still, job) : renderer_.render(order.still, job);
    outcome.cancelled = stop.stop_requested();
    if (outcome.cancelled) return outcome;
    if (!picture) {
      outcome.error = messageOf(picture.error());
      return outcome;
    }
    order.file.picture = std::move(*picture);
    order.file.look = order.still.look;
    paintMarks(order.still, order.file.picture);
    if (order.file.path.isEmpty()) {
      outcome.image = decorated(order.file);
    } else if (const auto written = writePictureFile(order.file); !written) {
      outcome.error = messageOf(written.error());
    }
  } catch (const std::bad_alloc&) {
    outcome.error = tr("There is not enough memory for a picture of %1 \u00d7 %2 pixels. Choose a "
                       "smaller size.")
                        .arg(order.still.shot.pixels.width())
                        .arg(order.still.shot.pixels.height());
  }
  return outcome;
}

void PictureJob::take(PictureOrder order, End end) {
  ++under_way_;
  holds_memory_ = true;
  auto work = [this, end = std::move(end), stop = stop_.get_token(),
               order = std::make_shared<PictureOrder>(std::move(order))]() -> Background::End {
    PictureOutcome outcome = make(*order, stop);
    return [this, end, outcome = std::move(outcome)] {
      --under_way_;
      end(outcome);
    };
  };
  if (StillRenderer::isThreaded()) {
    background_.run(std::move(work));
  } else {
    QTimer::singleShot(0, this, [work = std::move(work)] { work()(); });
  }
}

}  // namespace soffit::ui
