// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace soffit::io {

/// What is wrong with the header of a PLY file, or empty. Looked at before the importer, which
/// never returns from a header without an end and makes room for any number of elements.
///
/// Checked: the magic word; "end_header" within the first 64 KiB; no element count beyond the
/// file's size in bytes.
std::string plyHeaderProblem(const std::filesystem::path& file);

}  // namespace soffit::io
