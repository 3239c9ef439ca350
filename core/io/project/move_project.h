// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/import_project.h"
#include "core/io/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

/// Projects that move and grow: what they name goes with them.
namespace soffit::io {

/// Writes the project to another place and gives it as it is there.
///
/// Every file that it names is copied beside it, at the same place relative to the project: models
/// with their side files and textures, maps of materials, photometry with its TILT files, meshes
/// of luminaires, the environment's picture. In the same folder it is saveProject().
///
/// Errors: saveProject()'s; a file that cannot be read; a file of the same name and other content
/// at the new place. Nothing is written then but files that fitted.
Result<Project> saveProjectAs(const Project& project, const std::filesystem::path& path);

/// The project with one more model, copied beside it with its textures (into a folder of its own
/// where another file has its name already); the project file itself is not written.
///
/// Luminaires, layouts, cameras and materials stay as they are; materials that the project does
/// not know come with the model. written: receives the files that were not there before, relative
/// to the folder. Errors: an unreadable model; the disk's; cancelled.
Result<Project> withModel(const Project& project, const std::filesystem::path& model,
                          const ImportChoices& choices,
                          std::vector<std::string>* written = nullptr);

}  // namespace soffit::io
