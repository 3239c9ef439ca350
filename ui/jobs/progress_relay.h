// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"

#include <QElapsedTimer>
#include <QObject>

#include <mutex>
#include <string>

namespace soffit::ui {

/// Hands core's progress, told on any thread, to the GUI thread at a readable pace.
class ProgressRelay : public QObject, public ProgressObserver {
  Q_OBJECT

 public:
  explicit ProgressRelay(QObject* parent = nullptr);
  void onProgress(std::string_view stage, double done) override;

 Q_SIGNALS:
  /// stage: what is being done; done: share of the stage, 0..1.
  void progressed(const QString& stage, double done);

 private:
  std::mutex mutex_;
  std::string stage_;
  QElapsedTimer since_;
};

}  // namespace soffit::ui
