// SPDX-License-Identifier: MIT
#include "ui/viewport/camera_history.h"

#include <cstddef>

namespace soffit::ui {
namespace {

constexpr std::size_t kMost = 200;

}  // namespace

void CameraHistory::settle(const ViewCamera& camera) {
  if (now_ == camera) return;
  if (now_) {
    before_.push_back(*now_);
    if (before_.size() > kMost) before_.erase(before_.begin());
    after_.clear();
  }
  now_ = camera;
}

std::optional<ViewCamera> CameraHistory::back(const ViewCamera& now) {
  settle(now);
  if (before_.empty()) return std::nullopt;
  after_.push_back(*now_);
  now_ = before_.back();
  before_.pop_back();
  return now_;
}

std::optional<ViewCamera> CameraHistory::forward(const ViewCamera& now) {
  settle(now);
  if (after_.empty()) return std::nullopt;
  before_.push_back(*now_);
  now_ = after_.back();
  after_.pop_back();
  return now_;
}

void CameraHistory::clear() {
  now_.reset();
  before_.clear();
  after_.clear();
}

}  // namespace soffit::ui
