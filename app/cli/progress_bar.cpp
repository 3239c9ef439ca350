// SPDX-License-Identifier: MIT
#include "app/cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace soffit::cli {
namespace {

constexpr std::size_t kWidth = 78;
constexpr auto kInterval = std::chrono::milliseconds(100);

void put(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string progressLine(std::string_view stage, double done, std::size_t width) {
  const double share = std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 0.0;
  constexpr std::size_t kNumbers = 6;  // " 100 %"
  constexpr std::size_t kStage = 32;
  const std::string_view name = stage.substr(0, std::min(kStage, width));
  const std::size_t bar = width > kStage + kNumbers + 3 ? width - kStage - kNumbers - 3 : 0;
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(bar));
  const std::string line =
      fmt::format("{:<{}} [{}{}]{:>4.0f} %", name, kStage, std::string(filled, '='),
                  std::string(bar - filled, ' '), std::floor(100.0 * share));
  return line.substr(0, width);
}

ProgressBar::ProgressBar() : visible_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::onProgress(std::string_view stage, double done) {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (on_screen_ && stage == stage_ && done < 1.0 && now - drawn_ < kInterval) return;
  stage_ = stage;
  drawn_ = now;
  on_screen_ = true;
  put("\r" + progressLine(stage, done, kWidth));
}

void ProgressBar::clear() {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  if (!on_screen_) return;
  put("\r" + std::string(kWidth, ' ') + "\r");
  on_screen_ = false;
}

}  // namespace soffit::cli
