// SPDX-License-Identifier: MIT
#include "ui/jobs/relight_worker.h"

namespace soffit::ui {

void RelightWorker::setReflections(bool on) {
  {
    const std::scoped_lock lock(mutex_);
    reflects_ = on;
  }
  wake_.notify_all();
}

bool RelightWorker::lacksReflections() const {
  return reflects_ && has_solver_ && last_ && !columns_.solver()->operators().coarse &&
         reflections_.lacks(*columns_.solver(), *last_->scene);
}

void RelightWorker::makeReflections(const std::stop_token& stop) {
  reflections_.make(columns_.solver(), last_->scene, Job{nullptr, stop});
}

}  // namespace soffit::ui
