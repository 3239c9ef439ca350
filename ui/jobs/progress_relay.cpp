// SPDX-License-Identifier: MIT
#include "ui/jobs/progress_relay.h"

#include "ui/document/core_words.h"

namespace soffit::ui {
namespace {

constexpr qint64 kPaceMs = 50;

}  // namespace

ProgressRelay::ProgressRelay(QObject* parent) : QObject(parent) {
  since_.start();
}

void ProgressRelay::onProgress(std::string_view stage, double done) {
  {
    const std::scoped_lock lock(mutex_);
    if (stage == stage_ && since_.elapsed() < kPaceMs) return;
    stage_ = stage;
    since_.restart();
  }
  Q_EMIT progressed(coreWords(stage), done);
}

}  // namespace soffit::ui
