// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace soffit::io {

/// The file that a project names, absolute and free of links.
///
/// file    as written in the project: relative, forward slashes.
/// folder  the project's own.
/// Errors (place is left empty): no name, an absolute one, a file outside the folder (by ".." or
/// through a link), a missing file, a folder.
Result<std::filesystem::path> fileInFolder(const std::filesystem::path& folder,
                                           const std::string& file);

/// The folder in which a project file lies ("." for a bare name).
std::filesystem::path folderOf(const std::filesystem::path& project);

}  // namespace soffit::io
