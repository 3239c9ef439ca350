// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/move_project.h"
#include "ui/document/document.h"

namespace soffit::ui::testing {

/// Saves as the application does, without its dialogs.
inline bool saved(Document& document, const std::filesystem::path& path) {
  const auto written = io::saveProjectAs(document.current(), path);
  if (written) document.setSaved(*written);
  return written.ok();
}

}  // namespace soffit::ui::testing
