// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/view_camera.h"

#include <optional>
#include <vector>

namespace soffit::ui {

/// The places that a view was looked from: back and forward as in a browser. Apart from the
/// document's undo: looking is no edit.
class CameraHistory {
 public:
  /// The camera has come to rest here.
  void settle(const ViewCamera& camera);
  /// The camera before; nothing at the beginning. `now` is where one is, settled or not.
  std::optional<ViewCamera> back(const ViewCamera& now);
  std::optional<ViewCamera> forward(const ViewCamera& now);
  [[nodiscard]] bool canGoBack() const { return !before_.empty(); }
  [[nodiscard]] bool canGoForward() const { return !after_.empty(); }
  void clear();

 private:
  std::optional<ViewCamera> now_;
  std::vector<ViewCamera> before_;
  std::vector<ViewCamera> after_;
};

}  // namespace soffit::ui
