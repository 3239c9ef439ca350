// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/image/read_image.h"

#include <filesystem>

/// The text header of Radiance HDR files, which OpenImageIO neither fills nor keeps.
/// Source: Ward, "Radiance File Formats": lines KEY=value between "#?RADIANCE" and an empty line.
namespace soffit::io {

/// Puts lines KEY=value after the first line of an existing file.
/// Errors: the file cannot be read or written, or is no Radiance file.
Result<void> addRadianceHeader(const std::filesystem::path& path, const Metadata& metadata);

/// The header's KEY=value lines, FORMAT left out. Errors: as above.
Result<Metadata> readRadianceHeader(const std::filesystem::path& path);

}  // namespace soffit::io
