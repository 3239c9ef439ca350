// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace soffit::io {

/// No photometric file is near this size: the largest tables (1° × 0.5°, a quarter of a million
/// values) take 2 MB. It bounds the memory that any file can make us use.
inline constexpr std::size_t kMaxTextBytes = std::size_t{8} << 20;

/// The whole of a regular file, at most kMaxTextBytes.
Result<std::string> loadText(const std::filesystem::path& path);

/// Writes a text beside `path` and renames it: whole or not at all.
Result<void> saveText(const std::filesystem::path& path, std::string_view text);

}  // namespace soffit::io
