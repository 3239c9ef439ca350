// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// Files that are written whole or not at all.
namespace soffit::io {

/// What happens to a file that is there already.
enum class Previous { replaced, kept_as_backup };

/// Writes `content` to a temporary file in the same folder, has it reach the disk and renames it,
/// so that at any moment `path` holds the old or the new content, whole.
///
/// A symbolic link is followed; the mode of an existing file is kept; a device or a pipe is written
/// to as it stands. With kept_as_backup the old
/// content stays beside it as `path` with "~" added. Errors: the folder is missing or may not be
/// written, the path is a folder, the disk is full; nothing is left behind then.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 Previous previous = Previous::replaced);

/// Reads a whole file or pipe. Errors: missing, a folder, not readable, more than `most_bytes`.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::size_t most_bytes = std::size_t{1} << 28U);

}  // namespace soffit::io
