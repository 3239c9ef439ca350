// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace soffit::ui {

/// The files that a luminaire cannot do without: its photometry and its mesh.
std::vector<std::string> filesOf(const light::Luminaire& luminaire);

/// Files that luminaires and surroundings name but the project's folder does not hold yet:
/// photometry of the library, meshes made from the building, light probes. They reach the disk when
/// the project is saved, and only if the scene still names them.
class PendingFiles {
 public:
  /// The name under which `bytes` will lie in the folder: `wanted`, numbered on where another file
  /// has that name. The same bytes get the same name.
  std::string add(const std::string& wanted, std::string bytes,
                  const std::filesystem::path& folder);
  [[nodiscard]] const std::map<std::string, std::string>& files() const { return files_; }
  [[nodiscard]] bool holds(const std::string& name) const { return files_.contains(name); }
  /// Writes what the scene names and the folder lacks. Errors: the disk.
  [[nodiscard]] Result<void> write(const scene::Scene& scene,
                                   const std::filesystem::path& folder) const;

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace soffit::ui
