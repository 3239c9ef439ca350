// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace soffit::cli {

/// Draws progress on one line of stderr, and only when that is a terminal. Thread-safe. The line
/// is removed at the end, so that what follows starts in the first column.
class ProgressBar final : public ProgressObserver {
 public:
  ProgressBar();
  ~ProgressBar() override;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void onProgress(std::string_view stage, double done) override;
  /// Removes the line; further progress draws it again.
  void clear();

 private:
  const bool visible_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point drawn_;
  bool on_screen_ = false;
};

/// The line itself, `width` columns at most: "stage [=====     ]  50 %".
std::string progressLine(std::string_view stage, double done, std::size_t width);

}  // namespace soffit::cli
