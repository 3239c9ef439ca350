// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/project.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace soffit::ui {

/// Files that imports copied beside a project. As long as a project is open its undo steps may lead
/// back to them; those of imports that were undone, or never saved, go when it is closed.
class CopiedFiles {
 public:
  /// An import into a project's folder. model: its geometry entry; files: what was not there
  /// before, relative to the folder.
  void add(const std::filesystem::path& folder, const std::string& model,
           std::vector<std::string> files);
  /// The project in a folder was saved, with this geometry.
  void saved(const std::filesystem::path& folder, std::span<const io::GeometryEntry> geometry);
  /// Removes what no saved project names, and folders that are empty then. Files of an import stay
  /// as long as a later one is kept: that may use them, too.
  void removeUnneeded();

 private:
  struct Import {
    std::filesystem::path folder;
    std::string model;
    std::vector<std::string> files;
    bool needed = false;
  };
  std::vector<Import> imports_;  ///< in order
};

}  // namespace soffit::ui
