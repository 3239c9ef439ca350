// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string_view>

/// Progress and cancellation of long work.
namespace soffit {

/// Told how far a long computation is. Called from any thread, at most a few times per stage
/// and hundredth; implementations must be thread-safe and quick.
class ProgressObserver {
 public:
  virtual ~ProgressObserver() = default;
  /// stage  what is being done, a short noun phrase ("tracing gather rays").
  /// done   share of this stage that is done, 0..1.
  virtual void onProgress(std::string_view stage, double done) = 0;
};

/// What long work is handed: whom to tell and when to give up. Cheap to copy.
struct Job {
  ProgressObserver* observer = nullptr;
  std::stop_token stop;

  void report(std::string_view stage, double done) const {
    if (observer != nullptr) observer->onProgress(stage, done);
  }
  [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
};

}  // namespace soffit
