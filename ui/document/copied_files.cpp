// SPDX-License-Identifier: MIT
#include "ui/document/copied_files.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace soffit::ui {
namespace {

namespace fs = std::filesystem;

void remove(const fs::path& folder, const std::string& file) {
  std::error_code ignored;
  fs::path target = folder / file;
  fs::remove(target, ignored);
  // remove() leaves folders that hold anything.
  for (fs::path parent = target.parent_path(); parent != folder && !parent.empty();
       parent = parent.parent_path()) {
    if (!fs::remove(parent, ignored)) break;
  }
}

}  // namespace

void CopiedFiles::add(const fs::path& folder, const std::string& model,
                      std::vector<std::string> files) {
  imports_.push_back({folder, model, std::move(files), false});
}

void CopiedFiles::saved(const fs::path& folder, std::span<const io::GeometryEntry> geometry) {
  for (Import& import : imports_) {
    if (import.folder != folder) continue;
    import.needed =
        std::ranges::find(geometry, import.model, &io::GeometryEntry::file) != geometry.end();
  }
}

void CopiedFiles::removeUnneeded() {
  while (!imports_.empty()) {
    const Import import = std::move(imports_.back());
    imports_.pop_back();
    if (import.needed) {
      for (Import& earlier : imports_) earlier.needed |= earlier.folder == import.folder;
      continue;
    }
    for (const std::string& file : import.files) remove(import.folder, file);
  }
}

}  // namespace soffit::ui
