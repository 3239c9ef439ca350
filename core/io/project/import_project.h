// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/project.h"

#include <filesystem>
#include <optional>

namespace soffit::io {

struct ImportChoices {
  double unit = 1.0;       ///< metres per unit of the file, above 0
  std::optional<char> up;  ///< 'y' or 'z'; absent: what the file or its format says
  Job job;
};

/// Makes a project of an architectural model and writes it to `project` (NAME.soffit; its folder
/// is made if need be).
///
/// The model, the files that it names (MTL, BIN) and its textures are copied beside the project,
/// at the same relative places; textures stored inside the model are written out. The project has
/// the geometry, the materials that were found, a camera and a work plane in the largest space at
/// eye height (startingPlace()), the layout "Base" and no luminaires.
///
/// Errors: an unreadable model; a file of the same name but other content beside the project, or
/// anything that cannot be written. An existing project is kept as NAME.soffit~.
Result<Project> importProject(const std::filesystem::path& model,
                              const std::filesystem::path& project, const ImportChoices& choices);

}  // namespace soffit::io
